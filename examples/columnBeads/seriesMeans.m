% SERIESMEANS  Measured means of a series, in the order of the targets.
%
% CALL: [VALUE, N, SD] = seriesMeans (CASE, FOLDER, SERIES)
%
%   CASE    see newCase
%   FOLDER  of this example
%   SERIES  number of the series
%   VALUE   1 x T, mean over its trials of the size of the target's model. The
%           height of 4 mm is that of the profile, in cm of the column of 10.7
%   N       1 x T, number of trials (a length of the whole tank is left out)
%   SD      1 x T, standard deviation of one trial, from the trials within all
%           series; of the time 0.08 s, not 0.06: by which rule is not known
%
% See also: diagnoseChange, predictBeads

function [value, n, sd] = seriesMeans (Case, folder, series)
  [~, cells] = readCsvTable (fullfile (folder, 'trials.csv'));
  trials = str2double (cells);
  [~, cells] = readCsvTable (fullfile (folder, 'profiles.csv'));
  profiles = str2double (cells)(:, 4:end);
  column = struct ('toeAngle', 4, 'topAngle', 5, 'timeRest', 6, ...
                   'length', 7, 'height', 8);
  scatter = struct ('toeAngle', 1.1, 'topAngle', 1.5, 'timeRest', 0.08, ...
                    'length', 0.75, 'height', 0.35, 'profile', 0.024);
  T = numel (Case.targets);
  value = NaN (1, T);
  n = NaN (1, T);
  sd = NaN (1, T);
  for t = 1:T
    target = Case.targets(t);
    size_ = str2double (target.modelName(6:end));
    own = trials(:, 1) == series & trials(:, 2) == size_;
    name = target.result;
    if target.curve > 0
      name = 'profile';
      each = interp1 (0.01:0.02:0.99, profiles(own, :).', target.at);
    elseif strcmp (name, 'height') && size_ == 4
      each = 10.7 * max (profiles(own, 3:12), [], 2);
    else
      each = trials(own, column.(name));
      each(strcmp (name, 'length') & each == 40) = [];
    end
    value(t) = mean (each);
    n(t) = numel (each);
    sd(t) = scatter.(name);
  end
end

%!test
%! target = @(size_, name, curve, at) struct ( ...
%!   'modelName', ['Beads', size_], 'result', name, 'curve', curve, 'at', at);
%! Case.targets = [target('8', 'toeAngle', 0, NaN), ...
%!                 target('4', 'length', 0, NaN), target('8', '', 1, 0.1)];
%! folder = fileparts (which ('seriesMeans'));
%! [value, n] = seriesMeans (Case, folder, 1);
%! assert (n, [3, 2, 3]);                # one length is that of the whole tank
%! assert (value(1:2), [13.95, 32.75], 1e-9);
%! assert (value(3), ...
%!         mean ([0.7589, 0.7549, 0.7519, 0.7091, 0.7319, 0.7069]), ...
%!         1e-9);

% SPDX-License-Identifier: GPL-3.0-only

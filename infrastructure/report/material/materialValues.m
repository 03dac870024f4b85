% MATERIALVALUES  All values of a calibrated material, and where each is from.
%
% CALL: LIST = materialValues (CASE, CALIBRATION)
%
%   CASE         see newCase
%   CALIBRATION  decoded results/calibration.json
%   LIST         1 x n struct: name (variable), value, interval (1 x 2, NaN: none),
%                from ('calibrated', 'given': modelVars, 'model': data.head), label
%                and unit ('' where nobody says it)
%
% Of data.head only variables with the usual names of a material count, those of
% the first model that has them.
%
% See also: materialLines, sayExport

function list = materialValues (Case, calibration)
  folders = {Case.models.folder};
  folders = folders(~cellfun (@isempty, folders));
  values = struct ();
  for folder = fliplr (folders)
    head = fullfile (folder{1}, 'data.head');
    if isfile (head)
      values = mergeFields (values, headDefaults (head));
    end
  end
  isUsual = @(n) ~isempty (regexp (n, ['^(density|radius|youngsModulus|poissonsRatio|', ...
                                       'coefRestitution|coefFriction|', ...
                                       'coefRollingFriction|cohesion)(PP|PW|P|W)$'], ...
                                   'once'));
  listed = fieldnames (values)';
  values = rmfield (values, listed(~cellfun (isUsual, listed)));
  given = mergeFields (values, Case.modelVars);
  values = mergeFields (given, calibration.params);
  names = fieldnames (values)';
  [labels, units] = paramLabels (setfield (Case, 'names', names));
  list = struct ('name', names, 'value', struct2cell (values)', 'interval', [NaN, NaN], ...
                 'from', 'model', 'label', labels', 'unit', units');
  for k = 1:numel (list)
    if isfield (calibration.params, names{k})
      list(k).from = 'calibrated';
      range = jsonAt (calibration, {'interval90', names{k}});
      if isnumeric (range) && numel (range) == 2
        list(k).interval = range(:)';
      end
    elseif isfield (Case.modelVars, names{k})
      list(k).from = 'given';
    end
  end
end

%!test
%! raw = standInCase (tempname ());
%! raw.modelVars = struct ('densityP', 650);
%! Case = newCase (raw);
%! writeAtomic (fullfile (Case.models(1).folder, 'data.head'), ...
%!   ["variable radiusP equal 0.002 # m\nvariable a equal 1\nvariable densityP equal 1\n", ...
%!    "variable slotWidth equal 3\n"]);
%! c = struct ('params', struct ('a', 2), 'interval90', struct ('a', [1; 3]));
%! list = materialValues (Case, c);
%! [~, order] = sort ({list.name});
%! list = list(order);
%! assert ({list.name}, {'a', 'densityP', 'radiusP'});
%! assert ({list.from}, {'calibrated', 'given', 'model'});
%! assert ([list.value], [2, 650, 0.002]);
%! assert (list(1).interval, [1, 3]);
%! assert (list(3).label, 'radius of the grains');

% SPDX-License-Identifier: GPL-3.0-only

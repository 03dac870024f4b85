% SWAPRUN  Runs a reference and its change with LIGGGHTS, two packings each.
%
% CALL: Z = swapRun (TRUTH, GIVEN, FOLDER)
%
%   TRUTH   of lawSwap: number, form, strength, X, seeds (2 x 2)
%   GIVEN   of storedCampaign;  FOLDER  of the runs; finished ones are used again
%   Z       2 x T, means of the packings: of the reference, of the change; NaN
%           where a bench gave none
%
% See also: lawSwap, swapForms, benchRun

function Z = swapRun (truth, given, folder)
  addpath (fileparts (fileparts (mfilename ('fullpath'))));
  root = startBenchmarks ();
  forms = swapForms ();
  forms = [forms(strcmp ({forms.name}, 'nothing')), ...
           forms(strcmp ({forms.name}, truth.form))];
  Z = NaN (2, numel (given.value));
  for c = 1:2
    one = zeros (2, numel (given.value));
    for trial = 1:2
      own = fullfile (folder, sprintf ('%d-%d-%d', truth.number, c, trial));
      one(trial, :) = onePacking (truth, given, root, forms(c), ...
                                  truth.seeds(c, trial), own);
    end
    Z(c, :) = mean (one, 1);
  end
end

function z = onePacking (truth, given, root, form, seed, folder)
  room = struct ('sliding', diff (given.limits(:, 2)) * 0.4, ...
                 'rolling', diff (given.limits(:, 4)) * 0.4);
  set = form.values(truth.strength, room);
  set.runSeed = seed;
  set.readTime = 0.4;
  for j = 1:numel (given.names)
    set.(given.names{j}) = truth.X(j);
  end
  if isfield (set, 'slidingAdded')
    set.coefFrictionPP = set.coefFrictionPP + set.slidingAdded;
  end
  z = NaN (1, numel (given.value));
  [~, ~] = mkdir (folder);
  for b = 1:numel (given.benchNames)
    bench = given.benchNames{b};
    head = headDefaults (fullfile (root, 'DEMmodels', bench, 'data.head'));
    known = rmfield (set, setdiff (fieldnames (set)', fieldnames (head)'));
    script = fullfile (folder, [bench, '.sh']);
    writeAtomic (script, strjoin ([{'set -e'}, form.lines(truth.strength), ...
                                   {''}], "\n"));
    results = benchRun (fullfile (folder, bench), bench, known, ...
                        sprintf ('bash "%s"', script));
    of = given.bench == b;
    z(of) = results(1:sum (of));
  end
end

% SPDX-License-Identifier: GPL-3.0-only

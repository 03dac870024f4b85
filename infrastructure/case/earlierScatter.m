% EARLIERSCATTER  How runs of the models scattered over earlier packings.
%
% CALL: [SD, RUNS, MEANS] = earlierScatter (CASE)
%
%   CASE  see newCase
%   SD    1 x T, sd of a run in the unit of its target; NaN where nobody says it
%   RUNS  1 x T, from how many packings (0)
%   MEANS 1 x T, what these runs gave, in the unit of the results; NaN: no such runs
%
% From scatter.csv of the model (runScatter), as a share of the result, since the case
% may have a larger rig; as it is where the result is negative (a logarithm, a level).
% A result within three sd of 0 says too little of another set.

function [sd, runs, means] = earlierScatter (Case)
  [sd, means] = deal (NaN (1, numel (Case.targets)));
  runs = zeros (size (sd));
  if ~isfield (Case, 'models')
    return
  end
  info = targetInfo (Case);
  for k = 1:numel (Case.models)
    folder = Case.models(k).folder;
    if isempty (folder) || ~isfile (fullfile (folder, 'scatter.csv'))
      continue
    end
    [ofResult, ofMean, n] = runScatter (folder);
    names = {resultInfo(folder).name};
    for t = find ([Case.targets.model] == k)
      row = find (strcmp (names, resultOf (Case.targets(t), info(t))), 1);
      value = Case.targets(t).value;
      if abs (ofMean(row)) > 3 * ofResult(row)
        means(t) = ofMean(row);
        sd(t) = ofResult(row) * merge (means(t) > 0, value / means(t), 1);
        runs(t) = n(row);
      end
    end
  end
  isKnown = sd > 0 & isfinite ([Case.targets.value]);       % not of a target of 0
  sd(~isKnown) = NaN;
  runs(~isKnown) = 0;
end

function name = resultOf (target, info)
  name = info.name;
  if ~isempty (givenField (target, 'result', ''))
    name = target.result;
  end
end

%!test
%! % the heap of a rig twice as large; a result near 0 has no share; not measured
%! root = fileparts (fileparts (which ('startToolbox')));
%! Case.models = struct ('name', 'Heap', ...
%!                       'folder', fullfile (root, 'DEMmodels', 'Heap'));
%! Case.targets = struct ('value', {34.6, 1, NaN}, 'model', 1, 'index', {2, 4, 3});
%! [sd, runs, means] = earlierScatter (Case);
%! [ofResult, ofMean] = runScatter (Case.models.folder);
%! assert (sd, [ofResult(2) * 34.6 / ofMean(2), NaN, NaN], 1e-12);
%! assert (runs, [8, 0, 0]);
%! assert (means, [ofMean(2), NaN, ofMean(3)]);
%!test
%! % a logarithm is no share of its mean
%! root = fileparts (fileparts (which ('startToolbox')));
%! Case.models = struct ('name', 'Doser', ...
%!                       'folder', fullfile (root, 'DEMmodels', 'Doser'));
%! Case.targets = struct ('value', {-0.4, -2}, 'model', 1, 'index', {1, 6});
%! [sd, runs] = earlierScatter (Case);
%! ofResult = runScatter (Case.models.folder);
%! assert (sd, ofResult([1, 6]), 1e-12);
%! assert (runs, [6, 6]);

% SPDX-License-Identifier: GPL-3.0-only

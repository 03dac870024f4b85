% COUNTFINISHED  Finished runs that a result of a model rests on.
%
% CALL: N = countFinished (MODEL, CASE)
%
%   MODEL  scalar struct of resultInput: name, key, lastRun
%   CASE   see newCase
%   N      runs of that key up to lastRun that ended well and are not forgotten

function n = countFinished (model, Case)
  numbers = zeros (0, 1);
  for kind = readLibrary (runPlace (Case, model.name))
    isIt = strcmp (kind.input, model.key) & kind.runs(:, 2) == 1 & ...
           kind.runs(:, 1) <= model.lastRun;
    numbers = [numbers; kind.runs(isIt, 1)];
  end
  n = numel (unique (numbers));
end

% SPDX-License-Identifier: GPL-3.0-only

% DIAGNOSISCOST  What a diagnosis of a case will cost, before it starts.
%
% CALL: LINES = diagnosisCost (CASE, FORESEEN)
%
%   CASE   see newCase, with its candidate effects;  FORESEEN  of it, see foresee
%   LINES  1 x n cell of texts; none where nothing can be run, or no candidate is
%          listed
%
% See also: foreseeSets

function lines = diagnosisCost (Case, foreseen)
  lines = cell (1, 0);
  isRun = all (isfile (fullfile ({Case.models.folder}, 'runscript')));
  if isempty (Case.effects) || ~isRun
    return
  end
  seconds = foreseen.seconds .* [Case.models.cpu];
  isRun = measuredModels (Case);
  left = floor (Case.options.maxNewRuns / sum (isRun));
  [~, lines] = foreseeSets (foreseen.problem.effects, left, gapOptions ([]), ...
                            sum (seconds(isRun)));
  if ~isempty (Case.conditions)
    lines{1} = sprintf ('for %s: %s', countText (numel (Case.conditions), 'condition'), ...
                        strrep (lines{1}, 'all models', ...
                                strjoin ({Case.models(isRun).name}, ', ')));
  end
end

%!function lines = of (Case)
%!  lines = diagnosisCost (Case, foresee (Case, runsOfCase (Case)));
%!endfunction
%!test
%! raw = standInCase (tempname ());
%! Case = newCase (raw);
%! assert (of (Case), cell (1, 0));
%! own = struct ('name', 'own', 'variables', {{'e'}}, 'neutral', 0, 'limits', [0; 5]);
%! Case = withEffects (Case, own);
%! lines = of (Case);
%! assert (strncmp (lines{1}, 'at most 63 choices', 18), lines{1});
%! assert (numel (lines), 1);
%! evaluateDEM ([1, 2], plainCase (Case));
%! assert (! isempty (strfind (of (Case){2}, 'of one CPU')));
%! % of a change what is measured in the new state is run
%! Case.conditions = {'moist'};
%! value = {struct('value', 1), struct('value', 1), struct('value', NaN)};
%! [Case.targets.changed] = value{:};
%! assert (! isempty (regexp (of (Case){1}, ...
%!                            '^for 1 condition: .* are run with First: ')));

% SPDX-License-Identifier: GPL-3.0-only

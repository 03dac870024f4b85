% DIAGNOSISCOST  What a diagnosis of a case will cost, before it starts.
%
% CALL: LINES = diagnosisCost (CASE)
%
%   CASE   see newCase, with its candidate effects
%   LINES  1 x n cell of texts; none where nothing can be run, or no candidate is
%          listed
%
% See also: foreseeSets

function lines = diagnosisCost (Case)
  lines = cell (1, 0);
  isRun = all (isfile (fullfile ({Case.models.folder}, 'runscript')));
  if isempty (Case.effects) || ~isRun
    return
  end
  problem = newProblem (Case);
  seconds = foresee (Case, runsOfCase (Case)).seconds .* [Case.models.cpu];
  isRun = measuredModels (Case);
  left = floor (Case.options.maxNewRuns / sum (isRun));
  [~, lines] = foreseeSets (problem.effects, left, gapOptions ([]), sum (seconds(isRun)));
  if ~isempty (Case.conditions)
    lines{1} = sprintf ('for %s: %s', countText (numel (Case.conditions), 'condition'), ...
                        strrep (lines{1}, 'all models', ...
                                strjoin ({Case.models(isRun).name}, ', ')));
  end
end

%!test
%! raw = standInCase (tempname ());
%! Case = newCase (raw);
%! assert (diagnosisCost (Case), cell (1, 0));
%! own = struct ('name', 'own', 'variables', {{'e'}}, 'neutral', 0, 'limits', [0; 5]);
%! Case = withEffects (Case, own);
%! lines = diagnosisCost (Case);
%! assert (strncmp (lines{1}, 'at most 63 choices', 18), lines{1});
%! assert (numel (lines), 1);
%! evaluateDEM ([1, 2], plainCase (Case));
%! assert (! isempty (strfind (diagnosisCost (Case){2}, 'of one CPU')));
%! % of a change what is measured in the new state is run
%! Case.conditions = {'moist'};
%! value = {struct('value', 1), struct('value', 1), struct('value', NaN)};
%! [Case.targets.changed] = value{:};
%! assert (! isempty (regexp (diagnosisCost (Case){1}, ...
%!                            '^for 1 condition: .* are run with First: ')));

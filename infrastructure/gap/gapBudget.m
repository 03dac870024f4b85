% GAPBUDGET  Shares out the DEM runs that a diagnosis may still make.
%
% CALL: [OPTIONS, LINES] = gapBudget (CASE, BUDGET, GIVEN, SECONDS)
%
%   CASE     see newCase;  BUDGET  see newEvaluate
%   GIVEN    of gapProblemOf
%   SECONDS  scalar, core time of one set so far (NaN: not known)
%   OPTIONS  of gapOptions: maxNewRuns counts parameter sets, each of them a run
%            of every model
%   LINES    cellstr, what is foreseen, and what the budget leaves out
%
% Foreseen: 4 sets to screen each effect, less where there are many (64 in all,
% but 2 each), a plan of 5 (d + 1) for the three likeliest, 4 of a pair, 5 seeds
% for each of 4 compared sets, 12 to mend surrogates. Where Input.maxNewRuns
% allows less, screening comes first; effects for which nothing is left are the
% last of the list, and are named.

function [options, lines] = gapBudget (Case, budget, given, seconds)
  left = floor (budget.left / budget.perSet);
  names = {};
  if ~isempty (given.effects)
    names = {given.effects(~[given.effects.laboratory]).name};
  end
  K = numel (names);
  screen = min (max (floor (64 / max (K, 1)), 2), 4);
  plan = 5 * (numel (Case.names) + 1);
  share = [12, screen * K, min(K, 3) * (plan - screen), 4 * (K > 1), 20];
  wanted = sum (share);
  options = gapOptions (struct ('seed', Case.options.seed, 'screenRuns', ...
                                screen, 'maxNewRuns', ...
                                max (min (left, wanted), 0)));
  lines = {sprintf(['foreseen at most: %d sets (%d to mend surrogates, %d ' ...
                    'for each of %d effects, %d for the likeliest, %d of a ' ...
                    'pair, %d to verify)'], wanted, share(1), screen, K, ...
                   share(3:5))};
  if isfinite (seconds)
    hours = options.maxNewRuns * seconds / 3600;
    lines{end + 1} = sprintf ('that is %.1f core-hours at %.0f s a set', ...
                              hours, seconds);
  end
  if left < wanted
    lines{end + 1} = sprintf ('Input.maxNewRuns leaves %d of them', ...
                              max (left, 0));
    kept = floor (max (left - 20, 0) / screen);
    if kept < K && left > 0
      lines{end + 1} = ['without runs, unless there are some already: ', ...
                        strjoin(names(kept + 1:end), ', ')];
    end
  end
end

%!shared Case, effect, budget
%! Case.options.seed = 1;
%! Case.names = {'a', 'b', 'c', 'd'};
%! effect = struct ('name', 'e', 'laboratory', false);
%! budget = struct ('left', 3000, 'perSet', 2);
%!test
%! % 10, 20 and 40 effects with 4 parameters: with 30 neutral sets 192 or less
%! % up to 20 effects
%! sets = [];
%! for K = [10, 20, 40]
%!   given.effects = repmat (effect, 1, K);
%!   options = gapBudget (Case, budget, given, NaN);
%!   sets(end + 1) = options.maxNewRuns;
%! end
%! assert (sets(1), 12 + 40 + 63 + 4 + 20);
%! assert (sets(2) + 30 <= 200);
%! assert (sets(3), 12 + 80 + 69 + 4 + 20);
%!test
%! % what is left out is said
%! budget.left = 80;
%! given.effects = repmat (effect, 1, 10);
%! [options, lines] = gapBudget (Case, budget, given, 30);
%! assert (options.maxNewRuns, 40);
%! assert (~isempty (strfind (lines{2}, '0.3 core-hours at 30 s a set')));
%! assert (~isempty (strfind (lines{end}, 'e, e, e, e, e')));

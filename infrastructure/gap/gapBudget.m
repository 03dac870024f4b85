% GAPBUDGET  Shares out the DEM runs that a diagnosis may still make.
%
% CALL: [OPTIONS, LINES] = gapBudget (CASE, BUDGET, GIVEN, SECONDS)
%
%   CASE     see newCase;  BUDGET  see newEvaluate
%   GIVEN    of newProblem
%   SECONDS  scalar, core time of one set so far (NaN: not known)
%   OPTIONS  of gapOptions: maxNewRuns counts parameter sets, each of them a run
%            of every model
%   LINES    cellstr, what is foreseen, and what the budget leaves out
%
% Foreseen at most: each effect once, twice where it acts both ways; 6 batches
% of 5; 5 seeds of each of four compared sets; 12 to mend surrogates or to seek
% a gap. The runs end as soon as the answer stands (exploreEffects), and without
% a gap after the first ones and those that sought it. Where Input.maxNewRuns
% allows less, a third of it is kept to verify; effects for which nothing is
% left are the last of the list, and are named.

function [options, lines] = gapBudget (Case, budget, given, seconds)
  left = floor (budget.left / budget.perSet);
  options = gapOptions (struct ('seed', Case.options.seed));
  names = {};
  ends = zeros (1, 0);
  for effect = reshape (given.effects, 1, [])
    if ~effect.laboratory
      names{end + 1} = effect.name;
      ends(end + 1) = 1 + (effect.range(1) < 0);
    end
  end
  share = [12, sum(ends), options.batches * options.batch * ~isempty(ends), ...
           4 * options.verifyRuns];
  wanted = sum (share);
  options.maxNewRuns = max (min (left, wanted), 0);
  lines = {sprintf(['foreseen at most: %d sets (%d to mend surrogates, %d ' ...
                    'for %d effects once each, %d to tell the likeliest ' ...
                    'apart, %d to verify); %d to %d where there is no gap'], ...
                   wanted, share(1:2), numel (names), share(3:4), ...
                   share(2) + [0, options.seekRuns])};
  if isfinite (seconds)
    hours = options.maxNewRuns * seconds / 3600;
    lines{end + 1} = sprintf ('that is %.1f core-hours at %.0f s a set', ...
                              hours, seconds);
  end
  if left < wanted
    lines{end + 1} = sprintf ('Input.maxNewRuns leaves %d of them', ...
                              max (left, 0));
    first = left - min (share(4), floor (left / 3));
    missing = names(cumsum (ends) > first);
    if ~isempty (missing) && left > 0
      lines{end + 1} = ['without runs, unless there are some already: ', ...
                        strjoin(missing, ', ')];
    end
  end
end

%!shared Case, effect, budget
%! Case.options.seed = 1;
%! Case.names = {'a', 'b', 'c', 'd'};
%! effect = newEffect (struct ('name', 'e', 'variables', {{'e'}}, ...
%!                             'neutral', 0, 'limits', [0; 1]), 1);
%! budget = struct ('left', 3000, 'perSet', 2);
%!test
%! % 10, 20 and 40 effects; the third one acts both ways
%! sets = [];
%! for K = [10, 20, 40]
%!   given = struct ('value', 1, 'effects', repmat (effect, 1, K));
%!   given.effects(3).range = [-1, 1];
%!   options = gapBudget (Case, budget, given, NaN);
%!   sets(end + 1) = options.maxNewRuns;
%! end
%! assert (sets, 12 + [11, 21, 41] + 30 + 20);
%!test
%! % what is left out is said
%! budget.left = 26;
%! given = struct ('value', 1, 'effects', repmat (effect, 1, 10));
%! given.effects(10).name = 'last';
%! [options, lines] = gapBudget (Case, budget, given, 30);
%! assert (options.maxNewRuns, 13);
%! assert (~isempty (strfind (lines{2}, '0.1 core-hours at 30 s a set')));
%! assert (~isempty (strfind (lines{end}, 'already: last')));

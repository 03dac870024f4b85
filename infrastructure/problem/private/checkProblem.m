% CHECKPROBLEM  Refuses a description of matrices that is none.
%
% CALL: checkProblem (PROBLEM)
%
%   PROBLEM  struct of newProblem, every field present
%
% Errors: DEcalioc:newProblem:badShape, :badValue

function checkProblem (problem)
  checkShapes (problem);
  if ~isempty (problem.effects)
    checkNames ({problem.effects.name});
  end
  checkValues (problem);
  if ~any (isfinite (problem.value) & ~problem.held)
    error ('DEcalioc:newProblem:badValue', ...
           ['newProblem: VALUE must hold at least one measured value ' ...
            'that is not held out, got none.']);
  end
end

function checkShapes (problem)
  [T, p] = deal (numel (problem.value), columns (problem.limits));
  wanted = struct ('T', T, 'p', p);
  like = struct ('T', 'like VALUE', 'p', 'one a parameter, NaN for none');
  for field = problemFields ()
    n = numel (problem.(field.name));
    if isfield (wanted, field.count) && n ~= wanted.(field.count)
      error ('DEcalioc:newProblem:badShape', ...
             'newProblem: %s must be 1 x %d, %s, got %d values.', ...
             field.name, wanted.(field.count), like.(field.count), n);
    end
  end
  if ~all (problem.limits(1, :) < problem.limits(2, :))
    error ('DEcalioc:newProblem:badValue', ...
           ['newProblem: LIMITS must be 2 x %d with the lower limit ' ...
            'first in every column.'], p);
  end
  C = problem.covariance;
  if ~isempty (C) && ~(isequal (size (C), [T, T]) && issymmetric (C, 1e-9))
    error ('DEcalioc:newProblem:badShape', ...
           ['newProblem: COVARIANCE must be %d x %d and symmetric, got ' ...
            'a %d x %d matrix.'], T, T, rows (C), columns (C));
  end
end

% Results are kept by these names, as fields.
function checkNames (names)
  fields = cellfun (@(n) matlab.lang.makeValidName (n), names, ...
                    'UniformOutput', false);
  reserved = names(ismember (fields, {'null', 'unlisted'}));
  if ~isempty (reserved)
    error ('DEcalioc:newProblem:badValue', ...
           ['newProblem: no effect may be called %s, the name of a ' ...
            'probability of its own. Call it something else.'], reserved{1});
  end
  [~, first] = unique (fields, 'first');
  again = setdiff (1:numel (names), first);
  if ~isempty (again)
    error ('DEcalioc:newProblem:badValue', ...
           ['newProblem: names of effects must differ, as names of ' ...
            'variables too, got %s twice.'], names{again(1)});
  end
  both = find (~cellfun (@isempty, strfind (names, ' + ')), 1);
  if ~isempty (both)
    error ('DEcalioc:newProblem:badValue', ...
           ['newProblem: ''%s'' is no name of an effect, '' + '' joins ' ...
            'the names of two. Leave it out.'], names{both});
  end
end

function checkValues (problem)
  cost = problem.benchCost;
  if numel (cost) < max (problem.bench) || ~all (cost > 0)
    error ('DEcalioc:newProblem:badValue', ...
           ['newProblem: BENCHCOST must hold %d numbers above 0, one a ' ...
            'bench, got %s.'], max (problem.bench), mat2str (cost, 4));
  end
  bad = problem.trials(~(problem.trials > 0));
  if ~isempty (bad)
    error ('DEcalioc:newProblem:badValue', ...
           ['newProblem: TRIALS must be above 0, got %g. Give the ' ...
            'number of trials that each value is the mean of, Inf where SD ' ...
            'holds their scatter.'], bad(1));
  end
  if ~all (problem.sd(isfinite (problem.value)) >= 0)
    error ('DEcalioc:newProblem:badValue', ...
           ['newProblem: SD must be >= 0 for every measured target. ' ...
            'Give the standard uncertainty of each measurement.']);
  end
end

%!test
%! % what is no description, and names that would write over each other, or over
%! % a probability
%! given = struct ('value', [1, 2], 'sd', [1, 1], 'limits', [0; 1], ...
%!                 'bench', [1, 1]);
%! wrong = {'sdKnown', true, 'sdKnown must be 1 x 2'; ...
%!          'sd', 1, 'sd must be 1 x 2'; ...
%!          'trials', [1, 2, 3], 'trials must be 1 x 2'; ...
%!          'paramMean', [1, 2], 'paramMean must be 1 x 1'; ...
%!          'covariance', eye(3), 'COVARIANCE must be 2 x 2'; ...
%!          'limits', [1; 0], 'lower limit first'; ...
%!          'trials', 0, 'TRIALS must be above 0'; ...
%!          'benchCost', -1, 'BENCHCOST must hold 1'; ...
%!          'held', [true, true], 'at least one measured'; ...
%!          'sd', [1, -1], 'SD must be >= 0'}';
%! for one = wrong
%!   bad = setfield (given, one{1:2});
%!   fail ('newProblem (bad);', one{3});
%! end
%! fail ('newProblem (rmfield (given, ''sd''));', 'must have the field sd');
%! for names = {{'null', 'b'}, {'unlisted', 'b'}, {'a', 'a'}, ...
%!              {'a-b', 'a_b'}, {'a + b', 'c'}}
%!   given.effects = struct ('name', names{1}, 'laboratory', true);
%!   fail ('newProblem (given);', 'newProblem: ');
%! end

% SPDX-License-Identifier: GPL-3.0-only

% CHECKBENCHCOST  Checks what one measurement on each bench costs.
%
% CALL: P = checkBenchCost (OPTIM, N)
%
%   OPTIM  scalar struct, the optim of loadInput
%   N      number of models
%   P      1 x n faults, see checkFault
%
% Reasons: badCost costCount
%
% See also: checkOptim, nextTest

function p = checkBenchCost (optim, n)
  p = checkFault ();
  if ~isfield (optim, 'cost') || checkIs ('nothing', optim.cost)
    return
  end
  cost = optim.cost;
  cure = ['Write optim.cost(2) = 5; where a measurement on model 2 costs ' ...
          'five times the usual.'];
  isGood = checkIs ('vector', cost) && all (cost > 0 & isfinite (cost));
  if ~isGood
    p = checkFault ('badCost', 'optim.cost', ...
                    'numbers above 0, one a model', checkShow (cost), cure);
  elseif n > 0 && numel (cost) > n
    p = checkFault ('costCount', 'optim.cost', ...
                    sprintf ('at most %d value(s), one a model', n), ...
                    sprintf ('%d values', numel (cost)), cure);
  end
end

%!assert (isempty (checkBenchCost (struct ('cost', [1; 5]), 2)))
%!assert (isempty (checkBenchCost (struct ('cost', 3), 2)))
%!assert (isempty (checkBenchCost (struct (), 2)))
%!assert (checkBenchCost (struct ('cost', [1, 0]), 2).id, ...
%!        'DEcalioc:checkCase:badCost')
%!assert (checkBenchCost (struct ('cost', {{1, 2}}), 2).id, ...
%!        'DEcalioc:checkCase:badCost')
%!assert (checkBenchCost (struct ('cost', [1, 2, 3]), 2).id, ...
%!        'DEcalioc:checkCase:costCount')

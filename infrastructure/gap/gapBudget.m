% GAPBUDGET  Shares out the DEM runs that a diagnosis may still make.
%
% CALL: OPTIONS = gapBudget (CASE, LEDGER, GIVEN)
%
%   CASE     see newCase;  LEDGER  see newLedger
%   GIVEN    of gapProblemOf
%   OPTIONS  of gapOptions: maxNewRuns counts parameter sets, each of them a run
%            of every model
%
% Without Input.maxNewRuns: 4 for each effect, a plan for 3 survivors, 5 seeds
% for each of 4 compared sets, 12 to mend surrogates; at most 160.
%
% See also: diagnoseGap

function options = gapBudget (Case, ledger, given)
  left = floor ((Case.options.maxNewRuns - ledger('new')) / ...
                numel (Case.models));
  K = 0;
  if ~isempty (given.effects)
    K = sum (~[given.effects.laboratory]);
  end
  plan = 5 * (numel (Case.names) + 1);
  usual = min (160, 4 * K + min (K, 3) * (plan - 4) + 20 + 12);
  options = gapOptions (struct ('seed', Case.options.seed, ...
                                'maxNewRuns', max (min (left, usual), 0)));
end

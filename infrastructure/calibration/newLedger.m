% NEWLEDGER  Book of the DEM runs of one calibration.
%
% CALL: LEDGER = newLedger ()
%
%   LEDGER  containers.Map with the counts new, reused, failed, the sum
%           coreSeconds, levels (n x (v + 1): levels of a set that was run, its
%           core-seconds), models: Case.models with the seconds of their runs
%           so far, and isUsedUp: a run was not made, as Input.maxNewRuns was
%           reached; a handle: newEvaluate writes into it
%
% See also: newEvaluate, addSeconds

function ledger = newLedger ()
  ledger = containers.Map ({'new', 'reused', 'failed', 'coreSeconds', ...
                            'levels', 'models', 'isUsedUp'}, ...
                           {0, 0, 0, 0, [], [], false});
end

%!assert (newLedger ()('new'), 0)

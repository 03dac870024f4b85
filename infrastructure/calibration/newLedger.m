% NEWLEDGER  Book of the DEM runs of one calibration.
%
% CALL: LEDGER = newLedger ()
%
%   LEDGER  containers.Map with the counts new, reused, failed, the sum
%           coreSeconds, and models: Case.models with the seconds of their runs
%           so far; a handle: newEvaluate writes into it
%
% See also: newEvaluate, addSeconds

function ledger = newLedger ()
  ledger = containers.Map ({'new', 'reused', 'failed', 'coreSeconds', ...
                            'models'}, {0, 0, 0, 0, []});
end

%!assert (newLedger ()('new'), 0)

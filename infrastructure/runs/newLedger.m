% NEWLEDGER  Book of the DEM runs of one calibration.
%
% CALL: LEDGER = newLedger ()
%
%   LEDGER  containers.Map with the counts new, reused, failed and the sum
%           coreSeconds; a handle: newEvaluate writes into it
%
% See also: newEvaluate

function ledger = newLedger ()
  ledger = containers.Map ({'new', 'reused', 'failed', 'coreSeconds'}, ...
                           {0, 0, 0, 0});
end

%!assert (newLedger ()('new'), 0)

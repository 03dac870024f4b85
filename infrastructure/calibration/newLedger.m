% NEWLEDGER  Book of the DEM runs of one calibration.
%
% CALL: LEDGER = newLedger ()
%
%   LEDGER  containers.Map with the counts new, reused, failed, the sum
%           coreSeconds, levels (n x (v + 1): levels of a set that was run, its
%           core-seconds), and models: Case.models with the seconds of their
%           runs so far; a handle: newEvaluate writes into it
%
% See also: newEvaluate, addSeconds

function ledger = newLedger ()
  ledger = containers.Map ({'new', 'reused', 'failed', 'coreSeconds', ...
                            'levels', 'models'}, {0, 0, 0, 0, [], []});
end

%!assert (newLedger ()('new'), 0)

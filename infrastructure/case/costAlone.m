% COSTALONE  Tells whether a case has nothing but one cost, of which the smallest counts.
%
% CALL: YES = costAlone (CASE)
%
%   CASE  see newCase
%   YES   logical: its one target has the role 'smallest'
%
% Of such a case runs.csv is all there is: the history of an optimiser. What it was
% made of nobody knows, so there is nothing to miss, to confirm or to explain.
%
% See also: bestKnown

function yes = costAlone (Case)
  yes = any (strcmp ({Case.targets.role}, 'smallest'));
end

%!assert (costAlone (struct ('targets', struct ('role', {'calibrate', 'holdout'}))), false)
%!assert (costAlone (struct ('targets', struct ('role', 'smallest'))))

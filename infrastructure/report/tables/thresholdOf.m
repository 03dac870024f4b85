% THRESHOLDOF  A threshold of the diagnosis that a result was made with.
%
% CALL: X = thresholdOf (GAP, NAME, OTHER)
%
%   GAP    decoded gap/gap.json;  NAME  field of its thresholds (gapOptions)
%   X      the number; OTHER where an older file does not say it

function x = thresholdOf (gap, name, other)
  x = jsonAt (gap, {'thresholds', name});
  if isempty (x)
    x = other;
  end
end

%!assert (thresholdOf (struct ('thresholds', struct ('level', 0.1)), 'level', 0.05), 0.1)
%!assert (thresholdOf ([], 'level', 0.05), 0.05)

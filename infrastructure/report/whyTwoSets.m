% WHYTWOSETS  Why calibration and diagnosis show two sets: one sentence.
%
% CALL: TEXT = whyTwoSets ()
%
% Stands where values of the second set stand beside those of the first.

function text = whyTwoSets ()
  text = ['This is another set than that of the calibration: the ', ...
          'calibration meets tolerances, the diagnosis fits the measured ', ...
          'values, each weighed by its noise.'];
end

%!assert (! isempty (strfind (whyTwoSets (), 'another set')))

% BLINDHELD  Names of the results that sealed cases hold out.
%
% CALL: NAMES = blindHeld ()
%
%   NAMES  1 x 4 cellstr: of each bench, more than a quarter of all
%
% They are never fitted; how far a cure closes the gap is seen on them.
%
% See also: blindLab, blindHandOver

function names = blindHeld ()
  names = {'heightFoot', 'spreadTime', 'densityHigh', 'massOnPlate'};
end

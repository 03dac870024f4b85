% ISABSOLUTE  Whether tolerance and residual of a target have its unit.
%
% CALL: YES = isAbsolute (TARGET)
%
%   TARGET  element of Case.targets
%   YES     logical
%
% See also: halfWidth

function yes = isAbsolute (target)
  yes = isfield (target, 'isAbsolute') && target.isAbsolute;
end

%!assert (isAbsolute (struct ('tol', 1)), false)
%!assert (isAbsolute (struct ('isAbsolute', true)))

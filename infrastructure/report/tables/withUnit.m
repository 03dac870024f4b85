% WITHUNIT  A name with its unit in brackets.
%
% CALL: TEXT = withUnit (NAME, UNIT)
%
%   NAME, UNIT  texts; the unit may be '', or stand in the name already

function text = withUnit (name, unit)
  text = name;
  if ~isempty (unit) && isempty (strfind (name, ['(', unit, ')']))
    text = sprintf ('%s (%s)', name, unit);
  end
end

%!assert (withUnit ('slope', 'deg'), 'slope (deg)')
%!assert (withUnit ('slope (deg)', 'deg'), 'slope (deg)')
%!assert (withUnit ('slope', ''), 'slope')

% SPDX-License-Identifier: GPL-3.0-only

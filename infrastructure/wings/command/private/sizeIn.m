% SIZEIN  A number above 0 as a person types it, with or without a unit.
%
% CALL: [TEXT, FAULT, ECHO] = sizeIn (TEXT, UNIT)
%
%   As amountIn; neither 0 nor an empty answer is a size
%
% See also: amountIn

function [text, fault, echo] = sizeIn (text, unit)
  [text, fault, echo] = amountIn (text, unit);
  if isempty (fault) && ~(str2double (text) > 0)
    fault = strtrim (sprintf ('more than 0 %s is needed, got %s.', unit, text));
  end
end

%!assert (sizeIn ('4 mm', 'm'), '0.004')
%!assert (nthargout (2, @sizeIn, '0', 'm'), 'more than 0 m is needed, got 0.')
%!assert (isempty (nthargout (2, @sizeIn, '0.35', '')))

% SPDX-License-Identifier: GPL-3.0-only

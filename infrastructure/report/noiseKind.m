% NOISEKIND  The kind of a number that is known to its noise only.
%
% CALL: KIND = noiseKind (KIND, X, SD)
%
%   KIND  see plainNumber
%   X     the number;  SD  its standard error (NaN: not known)
%   KIND  'plain 2': with two digits. Of plain and change, where this is fewer
%         digits: to the second digit of SD, so 0.453 +- 2.1 is 0.5 +- 2.1

function kind = noiseKind (kind, x, sd)
  most = struct ('plain', 4, 'change', 3);
  if isscalar (x) && isfield (most, kind) && isfinite (sd) && sd > 0 && isfinite (x)
    digits = 0;
    if x ~= 0
      digits = 2 + floor (log10 (abs (x))) - floor (log10 (sd));
    end
    if digits < most.(kind)
      kind = sprintf ('%s %d', kind, max (digits, 0));
    end
  end
end

%!assert (noiseKind ('change', 0.453, 2.1), 'change 1')
%!assert (noiseKind ('plain', -4e-15, 0.034), 'plain 0')
%!assert (noiseKind ('plain', 0, 0.1), 'plain 0')
%!assert (noiseKind ('plain', 7.35, 0.001), 'plain')
%!assert (noiseKind ('plain', 7.35, NaN), 'plain')
%!assert (noiseKind ('p', 0.04, 0.1), 'p')
%!assert (noiseKind ('plain', [1, 2], 0.1), 'plain')

% SPDX-License-Identifier: GPL-3.0-only

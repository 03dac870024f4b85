% NOISEAT  Variance of a run of a response along the further input.
%
% CALL: V = noiseAt (SURROGATE, EXTRA)
%
%   EXTRA      n x 1, see fitSurrogate; of levels how coarse (unitLevel)
%   V          n x 1, in squared units of the response; of a surrogate whose
%              noise does not change its noiseVar

function v = noiseAt (surrogate, extra)
  if isempty (surrogate.noiseLaw)
    v = surrogate.noiseVar * ones (size (extra));
  else
    law = surrogate.noiseLaw;
    v = surrogate.scale^2 * exp (law(1) + law(2) * extra);
  end
end

%!test
%! s = struct ('noiseLaw', [], 'noiseVar', 4, 'scale', 3);
%! assert (noiseAt (s, [0; 1]), [4; 4]);
%! s.noiseLaw = [0, log(2)];
%! assert (noiseAt (s, [0; 1; 2]), [9; 18; 36], 1e-12);

% SPDX-License-Identifier: GPL-3.0-only

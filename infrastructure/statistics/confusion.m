% CONFUSION  Gives the chance that one effect is taken for another.
%
% CALL: P = confusion (COSINE, D)
%
%   COSINE  any shape, cosine of the two signatures
%   D       scalar or same shape, signal to noise of the true one
%   P       Phi (-D sqrt ((1 - COSINE) / 2))
%
% Two Gaussians whose means are the signatures: half their distance decides.

function p = confusion (cosine, d)
  p = normalTail (d .* sqrt (max (1 - cosine, 0) / 2));
end

%!assert (confusion (1, 5), 0.5)
%!assert (confusion (0, 2), normalTail (sqrt (2)), eps)

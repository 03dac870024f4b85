% NOISEAT  Variance of a run of a response at a level.
%
% CALL: V = noiseAt (SURROGATE, LEVEL)
%
%   LEVEL      n x 1, how coarse (unitLevel; 0 is the level that counts)
%   V          n x 1, in squared units of the response; of a surrogate without
%              levels its noiseVar

function v = noiseAt (surrogate, level)
  if isempty (surrogate.noiseLaw)
    v = surrogate.noiseVar * ones (size (level));
  else
    law = surrogate.noiseLaw;
    v = surrogate.scale^2 * exp (law(1) + law(2) * level);
  end
end

%!test
%! s = struct ('noiseLaw', [], 'noiseVar', 4, 'scale', 3);
%! assert (noiseAt (s, [0; 1]), [4; 4]);
%! s.noiseLaw = [0, log(2)];
%! assert (noiseAt (s, [0; 1; 2]), [9; 18; 36], 1e-12);

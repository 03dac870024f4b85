% BRIDGEPULL  How much liquid bridges matter: soon, then hardly more.
%
% CALL: B = bridgePull (CONTENT, SOON)
%
%   CONTENT  any shape, liquid content over its limit
%   SOON     scalar, content (over the limit) at which 1 - 1/e is reached
%   B        same shape, exactly 0 at 0, 1 at CONTENT 1
%
% The force of a pendular bridge hardly depends on its volume, so the pull grows
% with the number of bridges: (1 - exp (-c/c0)) / (1 - exp (-1/c0)).
%
% See also: bondPull, foreignLab

function B = bridgePull (content, soon)
  B = expm1 (-content / soon) / expm1 (-1 / soon);
end

%!test
%! assert (bridgePull (0, 0.3), 0);
%! B = bridgePull (0:0.25:1, 0.3);
%! assert (B(5), 1, 1e-12);
%! assert (all (diff (B) > 0) && all (diff (B, 2) < 0));

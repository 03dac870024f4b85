% UNKNOWNSOF  Lists the unknowns of a hypothesis, each with its prior.
%
% CALL: UNKNOWNS = unknownsOf (WHITE, H, PRIOR)
%
%   WHITE     struct of whitenEmulator
%   H         struct of newHypothesis
%   PRIOR     struct mean, sd (1 x p, of parameters in [-1, 1]; sd Inf: uniform)
%   UNKNOWNS  struct, all 1 x d: lo, hi (limits), mean, sd (of the normal part;
%             Inf: uniform), pLo, pHi (normal probability below each limit),
%             isScale (log-normal: mean and sd are those of the logarithm)
%
% Order: p parameters; where H has members their strengths and the amplitude
% error of their surrogates (predictHypothesis); the size of H.spread where it
% has one. Parameters are uniform in the box, or normal and cut to it where they
% were measured; strengths are normal around neutral, cut to the range of the
% effect; a size is log-normal.
%
% See also: fromNormal, newHypothesis, fitHypothesis

function unknowns = unknownsOf (white, h, prior)
  p = white.p;
  unknowns.lo = -ones (1, p);
  unknowns.hi = ones (1, p);
  unknowns.mean = prior.mean;
  unknowns.sd = prior.sd;
  for k = h.members
    e = white.effect(k);
    unknowns.lo(end + 1) = e.range(1);
    unknowns.hi(end + 1) = e.range(2);
    unknowns.mean(end + 1) = 0;
    unknowns.sd(end + 1) = e.scale;
  end
  if ~isempty (h.members)
    unknowns.lo(end + 1) = -Inf;
    unknowns.hi(end + 1) = Inf;
    unknowns.mean(end + 1) = 0;
    unknowns.sd(end + 1) = 1;
  end
  unknowns.isScale = false (size (unknowns.lo));
  if ~isempty (h.spread)
    unknowns.lo(end + 1) = 0;
    unknowns.hi(end + 1) = Inf;
    unknowns.mean(end + 1) = log (h.extent(1));
    unknowns.sd(end + 1) = h.extent(2);
    unknowns.isScale(end + 1) = true;
  end
  below = @(x) 1 - normalTail ((x - unknowns.mean) ./ unknowns.sd);
  unknowns.pLo = below (unknowns.lo);
  unknowns.pHi = below (unknowns.hi);
end

%!test
%! white = handMadeModels ().white;
%! prior = struct ('mean', 0, 'sd', Inf);
%! u = unknownsOf (white, newHypothesis ('sibling', 2), prior);
%! assert (u.lo, [-1, 0, -Inf, 0]);
%! assert (u.hi, [1, 1, Inf, Inf]);
%! assert (u.isScale, [false, false, false, true]);
%! assert (u.pHi(2), 0.97725, 1e-5);

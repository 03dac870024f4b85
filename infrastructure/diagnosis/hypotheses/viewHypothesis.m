% VIEWHYPOTHESIS  Puts together what a hypothesis needs to be evaluated.
%
% CALL: VIEW = viewHypothesis (WHITE, H, PRIOR)
%
%   WHITE  struct of whitenEmulator;  H  struct of newHypothesis
%   PRIOR  struct mean, sd (1 x p, of parameters in [-1, 1]; sd Inf: uniform)
%   VIEW   struct white, h, and unknowns: struct, all 1 x d: lo, hi (limits),
%          mean, sd (of the normal part; Inf: uniform), pLo, pHi (normal
%          probability below each limit), isScale (log-normal: mean and sd are
%          those of the logarithm)
%
% Order of the unknowns: p parameters; where H has members their strengths and
% the amplitude error of their surrogates (predictHypothesis); the size of
% H.spread where it has one. Parameters are uniform in the box, or normal and
% cut to it where they were measured; strengths are normal around neutral, cut
% to the range of the effect; the size of a form error is half-normal, that of a
% discrepancy log-normal.

function view = viewHypothesis (white, h, prior)
  m = numel (h.members);
  range = zeros (2, m);
  scale = zeros (1, m);
  for i = 1:m
    range(:, i) = white.effect(h.members(i)).range;
    scale(i) = white.effect(h.members(i)).scale;
  end
  amplitude = ones (1, m > 0);
  spread = ones (1, ~isempty (h.spread));
  isScale = strcmp (h.spread, 'discrepancy');
  middle = 0;
  if isScale
    middle = log (h.extent(1));
  end
  box = ones (1, white.p);
  of = struct ('lo', [-box, range(1, :), -Inf * amplitude, 0 * spread], ...
               'hi', [box, range(2, :), Inf * amplitude, Inf * spread], ...
               'mean', [prior.mean, zeros(1, m), 0 * amplitude, ...
                        middle * spread], ...
               'sd', [prior.sd, scale, amplitude, ...
                      h.extent(end) * spread]);
  of.isScale = [false(1, white.p + m), amplitude == 0, ...
                spread & isScale];
  % what the limits cut off a normal prior: fromNormal spreads the rest
  below = @(x) 1 - normalTail ((x - of.mean) ./ of.sd);
  of.pLo = below (of.lo);
  of.pHi = below (of.hi);
  view = struct ('white', white, 'h', h, 'unknowns', of);
end

%!test
%! white = handMadeHypotheses ().white;
%! prior = struct ('mean', 0, 'sd', Inf);
%! h = newHypothesis ('single', 2);
%! u = viewHypothesis (white, h, prior).unknowns;
%! assert (u.lo, [-1, 0, -Inf, 0]);
%! assert (u.hi, [1, 1, Inf, Inf]);
%! assert (u.sd(4), 0.42);
%! assert (u.isScale, [false, false, false, false]);
%! kind = newHypothesis ('discrepancy', zeros (1, 0), [0.1, 1]);
%! assert (viewHypothesis (white, kind, prior).unknowns.isScale, ...
%!         [false, true]);
%! assert (u.pHi(2), 0.97725, 1e-5);
%! null = viewHypothesis (white, newHypothesis ('null'), prior);
%! assert (numel (null.unknowns.lo), 1);

% SPDX-License-Identifier: GPL-3.0-only

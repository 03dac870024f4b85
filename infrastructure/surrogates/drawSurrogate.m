% DRAWSURROGATE  Draws responses at some sets from a surrogate's posterior.
%
% CALL: DRAW = drawSurrogate (SURROGATE, P, N)
%
% SURROGATE  scalar struct of fitSurrogate
% P          m x d, parameter sets
% N          number of draws
% DRAW       m x n, responses without the noise of a run; the sets of one draw
%            vary together. Taken from randn, which the caller seeds

function draw = drawSurrogate (surrogate, P, n)
  [S, m] = posteriorCovariance (surrogate, P);
  S = (S + S') / 2 + 1e-8 * mean (diag (S)) * full (eye (rows (S)));
  [Q, D] = eig (S);
  root = Q .* sqrt (max (diag (D), 0))';
  draw = m + root * randn (rows (S), n);
  draw = surrogate.shift + surrogate.scale * draw;
end

%!test
%! % mean and spread of 4000 draws are those of predictSurrogate
%! pkg load stk
%! restore = seedRandom (1);
%! X = [0; 0.2; 0.5; 0.6; 1];
%! s = fitSurrogate (X, [1; 3; 2; 2.5; 0], [0; 1], struct ());
%! P = [0.1; 0.35; 0.8];
%! draw = drawSurrogate (s, P, 4000);
%! [m, v] = predictSurrogate (s, P);
%! sd = sqrt (v / s.factor);
%! assert (mean (draw, 2), m, 5 * max (sd) / sqrt (4000));
%! assert (std (draw, 0, 2), sd, 5 * max (sd) / sqrt (8000));

% FITLIBRARY  Fits the null model, each effect and unlisted causes to data sets.
%
% CALL: FITS = fitLibrary (MODELS, Y)
%
%   MODELS  struct of makeModels
%   Y       n x T', data sets: values of the targets MODELS.white.columns
%   FITS    struct
%     Z       n x T', whitened Y
%     null    fit of fitHypothesis, best start of each row
%     single  1 x K cell of such fits, with fields other (the second best
%             distinct mode, same fields) and hasOther (n x 1 logical)
%     kind    1 x m cell of such fits, in the coordinates of each kind
%     rotated 1 x m cell, Y in those coordinates
%
% See also: weighCase, fitHypothesis

function fits = fitLibrary (models, Y)
  white = models.white;
  fits.Z = Y * white.W';
  n = rows (Y);
  fits.null = bestOf (white, [], fits.Z, repeat (models.starts, n), ...
                      models.prior);
  for k = 1:numel (white.effect)
    phi = startStrengths (white.effect(k).range);
    Q = [kron(fits.null.Q, ones (numel (phi), 1)), repmat(phi(:), n, 1)];
    fits.single{k} = bestOf (white, k, fits.Z, Q, models.prior);
  end
  for k = 1:numel (models.kinds)
    kind = models.kinds(k);
    fits.rotated{k} = Y * kind.white.W';
    starts = [kron(fits.null.Q, [1; 0])];
    fits.kind{k} = bestOf (kind.white, [], fits.rotated{k}, starts, ...
                           models.prior);
  end
end

function Q = repeat (starts, n)
  Q = repmat (starts, n, 1);
end

function phi = startStrengths (range)
  phi = [0.12, 0.45, 0.85] * range(2);
  if range(1) < 0
    phi = [0.8 * range(1), 0.25 * range(1), 0.25 * range(2), 0.8 * range(2)];
  end
end

% The starts of one data set follow each other in Q.
function best = bestOf (white, h, Z, Q, prior)
  n = rows (Z);
  s = rows (Q) / n;
  box = hypothesisBox (white, h, prior);
  all = fitHypothesis (white, h, kron (Z, ones (s, 1)), Q, box);
  cost = reshape (all.cost, s, n);
  [~, first] = min (cost, [], 1);
  at = (0:n - 1) * s + first;
  best = pick (all, at);
  far = sqrt (sum ((all.Q - kron (best.Q, ones (s, 1))).^2, 2)) > 0.3;
  cost(~reshape (far, s, n)) = Inf;
  [second, which] = min (cost, [], 1);
  best.other = pick (all, (0:n - 1) * s + which);
  best.hasOther = (second' - best.cost) < 5;
end

function part = pick (all, at)
  part = struct ('Q', all.Q(at, :), 'cost', all.cost(at), ...
                 'chi2', all.chi2(at), 'A', all.A(at, :, :));
end

%!test
%! models = handMadeModels ();
%! fits = fitLibrary (models, [1.5, 0.5, 2, 2; 0, 0, 0, -2]);
%! assert (fits.null.Q, [0.5; 0], 1e-3);
%! assert (fits.single{1}.Q(1, :), [0.5, 16 / 36], 0.02);
%! assert (fits.single{2}.Q(2, :), [0, 8 / 20], 0.03);
%! assert (size (fits.kind{1}.Q), [2, 1]);

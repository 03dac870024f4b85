% FITLIBRARY  Fits every hypothesis of the table to data sets.
%
% CALL: FITS = fitLibrary (HYPOTHESES, Y)
%
%   HYPOTHESES  struct of makeHypotheses
%   Y       n x T', data sets: values of the targets HYPOTHESES.white.columns
%   FITS    struct
%     Z        n x T', whitened Y
%     of       1 x H cell, a row of HYPOTHESES.list each: struct as of fitHypothesis
%              with the best start of each data set, and Z (the data in its
%              coordinates), other (the second best distinct mode, same fields),
%              hasOther (n x 1 logical), logSum (n x 1: log evidence of both)
%     calibrated  the null model with a flat prior in the box: what a
%              calibration finds
%     logE     n x H, Laplace evidences

function fits = fitLibrary (hypotheses, Y)
  H = numel (hypotheses.list);
  fits = struct ('Z', Y * hypotheses.white.W', 'of', {cell(1, H)}, ...
                 'logE', zeros (rows (Y), H));
  for j = 1:H
    row = hypotheses.list(j);
    parent = [];
    if row.from > 0
      parent = fits.of{row.from};
    end
    fits.of{j} = fitRow (row, parent, Y, hypotheses.prior);
    fits.logE(:, j) = fits.of{j}.logSum;
  end
  % a calibration minimises misses alone, so its set has no prior
  flat = setfield (hypotheses.prior, 'flat', true);
  null = hypotheses.list(1);
  fits.calibrated = fitHypothesis (null.white, null.h, fits.Z, ...
                                   fits.of{1}.U, flat);
end

function best = fitRow (row, parent, Y, prior)
  s = rows (row.starts);
  U = repmat (row.starts, rows (Y), 1);
  if ~isempty (parent)
    U = [kron(parent.U, ones (s, 1)), U];
  end
  Z = Y * row.white.W';
  best = bestOf (row.white, row.h, Z, U, prior);
  best.Z = Z;
end

% The starts of one data set follow each other in U.
function best = bestOf (white, h, Z, U, prior)
  n = rows (Z);
  s = rows (U) / n;
  tried = fitHypothesis (white, h, kron (Z, ones (s, 1)), U, prior);
  logE = reshape (tried.logE, s, n);
  [first, at] = max (logE, [], 1);
  best = pick (tried, (0:n - 1) * s + at);
  best.logSum = first';
  best.hasOther = false (n, 1);
  if s == 1
    return
  end
  % ends within half a deviation of the prior are one mode that rounding has split
  far = sqrt (sum ((tried.U - kron (best.U, ones (s, 1))).^2, 2)) > 0.5;
  logE(~reshape (far, s, n)) = -Inf;
  [second, at] = max (logE, [], 1);
  best.other = pick (tried, (0:n - 1) * s + at);
  % a mode that is less likely by exp (4) adds less than 2 %
  best.hasOther = (first - second)' < 4;
  best.logSum = best.logSum + best.hasOther .* log1p (exp (second - first)');
end

function part = pick (tried, at)
  part = struct ('U', tried.U(at, :), 'Q', tried.Q(at, :), ...
                 'chi2', tried.chi2(at), 'A', tried.A(at, :, :), ...
                 'logE', tried.logE(at));
end

%!test
%! hypotheses = handMadeHypotheses ();
%! fits = fitLibrary (hypotheses, [1.5, 0.5, 2, 2; 0, 0, 0, -2]);
%! assert (fits.calibrated.Q, [0.5; 0], 1e-3);
%! assert (fits.of{1}.Q, [0.5; 0], 0.1);
%! assert (fits.of{2}.Q(1, 1:2), [0.5, 16 / 36], 0.1);
%! assert (fits.of{3}.Q(2, 1:2), [0, 8 / 20], 0.1);
%! assert (size (fits.of{4}.Q), [2, 2]);
%! assert (size (fits.logE), [2, 4]);
%! % the right effect has the larger evidence
%! assert (fits.logE(1, 2) > max (fits.logE(1, [1, 3:4])));

% SPDX-License-Identifier: GPL-3.0-only

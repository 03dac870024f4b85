% FOREIGNLABORATORIES  Makes the laboratories of the studies on foreign laws.
%
% CALL: LABS = foreignLaboratories (KIND)
%
%   KIND  'blind' (4 laboratories), 'develop' (2 others) or 'curve' (3, see
%         foreignLab)
%   LABS  1 x L struct: name, gapProblem (value still NaN), data
%         (40 neutral runs, 20 for each effect of DEM), means, measure, noiseSd,
%         isSigned, em (of fitEmulator), noise (1 x T, or T x T where the
%         measurement has a covariance: measurement, packing and surrogate)
%
% See also: foreignLab, twinsLaboratories, foreignTwins

function labs = foreignLaboratories (kind)
  counts = struct ('blind', 4, 'develop', 2, 'curve', 3);
  firstSeed = struct ('blind', 500, 'develop', 600, 'curve', 700);
  runs = 40;
  for i = 1:counts.(kind)
    lab = foreignLab (kind, i);
    rand ('twister', firstSeed.(kind) + i);
    randn ('twister', firstSeed.(kind) + i);
    one = struct ('name', lab.name, 'gapProblem', lab.gapProblem, ...
                  'data', lab.plan (runs, 20), 'means', lab.means, ...
                  'measure', lab.measure, 'noiseSd', lab.noiseSd, ...
                  'isSigned', lab.isSigned);
    given = lab.gapProblem;
    given.value = mean (one.data.Z);
    one.em = fitEmulator (newGapProblem (given), one.data, gapOptions ([]));
    surrogate = mean (one.em.surrogateVar, 1);
    one.noise = sqrt (lab.gapProblem.sd.^2 + lab.noiseSd.^2 + surrogate);
    if isfield (lab.gapProblem, 'covariance')
      sd = lab.gapProblem.sd;
      correlation = lab.gapProblem.covariance ./ (sd' * sd);
      one.noise = correlation .* (sd' * sd + lab.noiseSd' * lab.noiseSd) + ...
                  diag (surrogate);
    end
    labs(i) = one;
  end
end

%!test
%! labs = foreignLaboratories ('develop');
%! assert ({labs.name}, {'chute1', 'taps2'});
%! assert (size (labs(2).data.Z), [40 + 5 * 20, 12]);
%! assert (all (labs(1).noise > labs(1).noiseSd));
%!test % noise of the curve: neighbours as correlated as declared, but for the
%! % share of the surrogate
%! labs = foreignLaboratories ('curve');
%! C = labs(3).noise;
%! assert (C(1, 2) / C(1, 1) > 0.5 && C(1, 2) / C(1, 1) < 0.9);

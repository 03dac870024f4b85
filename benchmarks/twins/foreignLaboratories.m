% FOREIGNLABORATORIES  Makes the laboratories of the studies on foreign laws.
%
% CALL: LABS = foreignLaboratories (KIND)
%
%   KIND  'blind' (4 laboratories), 'develop' (2 others) or 'curve' (3, see
%         foreignLab)
%   LABS  1 x L struct: name, problem (of newGapProblem, y still NaN), data
%         (40 neutral runs, 20 for each effect of DEM), means, measure, seedSd,
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
    one = struct ('name', lab.name, 'problem', lab.problem, ...
                  'data', lab.plan (runs, 20), 'means', lab.means, ...
                  'measure', lab.measure, 'seedSd', lab.seedSd, ...
                  'isSigned', lab.isSigned);
    given = lab.problem;
    given.y = mean (one.data.Z);
    one.em = fitEmulator (newGapProblem (given), one.data, gapOptions ([]));
    surrogate = mean (one.em.surrogateVar, 1);
    one.noise = sqrt (lab.problem.sd.^2 + lab.seedSd.^2 + surrogate);
    if isfield (lab.problem, 'covariance')
      sd = lab.problem.sd;
      correlation = lab.problem.covariance ./ (sd' * sd);
      one.noise = correlation .* (sd' * sd + lab.seedSd' * lab.seedSd) + ...
                  diag (surrogate);
    end
    labs(i) = one;
  end
end

%!test
%! labs = foreignLaboratories ('develop');
%! assert ({labs.name}, {'chute1', 'taps2'});
%! assert (size (labs(2).data.Z), [40 + 5 * 20, 12]);
%! assert (all (labs(1).noise > labs(1).seedSd));
%!test % noise of the curve: neighbours as correlated as declared, but for the
%! % share of the surrogate
%! labs = foreignLaboratories ('curve');
%! C = labs(3).noise;
%! assert (C(1, 2) / C(1, 1) > 0.5 && C(1, 2) / C(1, 1) < 0.9);

% FOREIGNLABORATORIES  Makes the laboratories of the studies on foreign laws.
%
% CALL: LABS = foreignLaboratories (KIND)
%
%   KIND  'blind' (4 laboratories) or 'develop' (2 others)
%   LABS  1 x L struct: name, problem (value still NaN), data
%         (40 neutral runs, 20 for each effect of DEM), means, measure, noiseSd,
%         isSigned, emulator (of fitEmulator), noise (1 x T: measurement, packing and
%         surrogate)
%
% See also: foreignLab, foreignTwins

function labs = foreignLaboratories (kind)
  counts = struct ('blind', 4, 'develop', 2);
  firstSeed = struct ('blind', 520, 'develop', 600);
  runs = 40;
  for i = 1:counts.(kind)
    lab = foreignLab (kind, i);
    rand ('twister', firstSeed.(kind) + i);
    randn ('twister', firstSeed.(kind) + i);
    one = struct ('name', lab.name, 'problem', lab.problem, ...
                  'data', lab.plan (runs, 20), 'means', lab.means, ...
                  'measure', lab.measure, 'noiseSd', lab.noiseSd, ...
                  'isSigned', lab.isSigned);
    given = lab.problem;
    given.value = mean (one.data.Z);
    one.emulator = fitEmulator (newProblem (given), one.data, gapOptions ([]));
    surrogate = mean (one.emulator.surrogateVar, 1);
    one.noise = sqrt (lab.problem.sd.^2 + lab.noiseSd.^2 + surrogate);
    labs(i) = one;
  end
end

%!test
%! labs = foreignLaboratories ('develop');
%! assert ({labs.name}, {'chute1', 'taps2'});
%! assert (size (labs(2).data.Z), [40 + 5 * 20, 12]);
%! assert (all (labs(1).noise > labs(1).noiseSd));

% GAPOPTIONS  Fills the options of a diagnosis with their defaults.
%
% CALL: OPTIONS = gapOptions (GIVEN)
%
%   GIVEN    struct with any of the fields ([] = all defaults)
%   OPTIONS  struct with all of them
%     seed         random numbers start here (1)
%     points       first draw of each integral (400), effective points wanted
%                  (400) and most points drawn (12000): points, effective, most
%     bootstrap    repetitions of the fit test (999)
%     twins        twins without a gap, drawn from the surrogates, that the gate
%                  compares with (400)
%     covariance   of the baseline Kriging ('matern52'; 'choose' tries more)
%     trend        of the same ('choose')
%     maxNewRuns   DEM runs that the diagnosis may spend in all (0)
%     explore      make runs before the verdict (true); without, only those that
%                  verify a cure
%     neutral      sets without an effect that a case runs first, for each
%                  parameter and one (4: fewer make most surrogates vague, and
%                  where four are too few runs that mend them are added)
%     batch        runs between two looks at the evidence (5: fewer cost more
%                  fits, more are chosen on older knowledge)
%     batches      batches that a diagnosis foresees (6: one in ten needs more
%                  than five)
%     standsAt     probability of an effect at which no more runs are made for
%                  it (0.9: as nameAt)
%     standsRuns   runs that it and its likeliest rival need for that (4: with
%                  fewer, chance names one in twenty wrongly)
%     alikeRuns    runs that it and the effect most like it need for that, from
%                  a cosine of alikeAt on (8: from there on a bend is known)
%     mostRuns     runs of an effect from which on batches add none (12: its
%                  bend is known from 8 on, see learnEffect)
%     worthAt      bits about the cause below which a batch is not run (0.03: a
%                  probability of 0.95 that moves by less than 0.02)
%     seekAt       p of the gate below which it is doubtful that there is no gap
%                  (0.5), and
%     seekRuns     neutral sets near the fitted one that a diagnosis wants then
%                  before it says so (10)
%     verifyRuns   seeds at each compared set when the cure is checked (5)
%   the thresholds of the verdict, all of them here (docs/gap-method.md):
%     level        chance of a false alarm (0.05)
%     surplus      variance of data without a gap over what the budget says
%                  (1.15; at 1 laboratories of formulas alarm in 9 %)
%     caution      power of the likelihood in intervals of strengths (0.4: at 1
%                  they hold that of laboratories of other laws in 66 % where
%                  they should in 90 %; closed study intervalCaution.m)
%     nameAt       probability that the effect takes part at which it is named
%                  (0.9: chosen on development draws, docs/gap-figures.md)
%     groupAt      probability at which effects are a class or a group (0.8)
%     classNats    log of the factor by which an effect may be less likely than
%                  the likeliest one and is not told from it yet (6), and
%     classAt      cosine of their marks from which that makes them a class
%                  (0.85: half of what an error of form makes of one has the
%                  tangent to the other; docs/gap-figures.md)
%     vagueRun     variance that comes with the surrogate of an effect, over all
%                  noise, above which it tells nothing between two effects (0.25)
%     leastPoints  effective points below which no number is believed (200: an
%                  error of 0.07 in the logarithm of the evidence)
%     misfitAt     probability of discrepancies at which the cause is off the
%                  list (0.5: likelier than not)
%     turnedAt     tangent of the angle between what an effect does and what its
%                  law makes of it from which that is another cause (1: half of
%                  what it does is not its own)
%     othersAt     share of a named effect's probability that none may have that
%                  explains the data without it (0.1)
%     alikeAt      cosine from which a partner counts as such another one (0.7:
%                  half of a signature is the other)
%     partnerAt    probability of a pair at which its other member is a partner
%                  (0.05: what 0.95 would not leave out)
%     rivalAt      probability of another effect from which it is the placebo of
%                  a cause, else the one most like it is (0.05)
%     gluedAt      posterior mass at the end of the range of a strength from
%                  which this is said (0.5: likelier outside than inside)
%     confusedAt   chance to mistake one effect for another at which they form a
%                  group (0.1, see nameCause)
%     leftAt       standard deviations by which DEM runs with the named effect
%                  may miss a target, and from which one miss is a gap to close
%                  (4: by chance 1 of 1000 with 16 targets)
%     hiddenAt     share of a direction that parameters hide from which it tells
%                  nothing of a gap to close (0.9: as blindAt)
%     blindAt      share of a target's variance that parameters absorb at which
%                  it is a blind spot (0.9)
%     limitAt      share of half its box, or of its range, at which a parameter
%                  or a strength is at its limit (0.98: closer than a surrogate
%                  can tell)
%     looMeanAt    mean square of the standardised leave-one-out errors of a
%                  target at which its surrogate contradicts its runs (2: of 40
%                  runs less than 1 in 1000 by chance), or the largest of them
%     looMostAt    (5)
%     looEffectAt  the same mean square for the runs of an effect, from six on
%                  (2.5: fewer runs)
%     vagueAt      share of the variance that is the surrogates' at which they
%                  hide a gap, or that of the likeliest effect's mark at which
%                  it needs more runs (0.5: more than all else together)
%     blameAt      share of targets with such surrogates at which these are to
%                  blame (0.2: a few are left to the noise budget)
%     conflictAt   p at which two benches contradict each other (0.01: six
%                  benches make 15 pairs)
%     pairAt       probability at which a pair of effects gets runs of its own
%                  (0.2: four runs cost as much as screening one effect)
%     adviseAt     bits about the kind of cause below which no measurement is
%                  advised, and none sought (0.2: a yes or no that is right in
%                  three of four cases)
%     testRuns     most runs of tests that the case does not have (120: of six
%                  tests all have eight, the best three twenty, the best two
%                  32)
%     fitMargin    misfit that a fit may leave because it ends early (0.02: ten
%                  times the step in log density at which fitHypothesis ends)
%
% See also: diagnoseMatrices, judgeCase

function options = gapOptions (given)
  options = struct ('seed', 1, 'points', 400, 'effective', 400, ...
                    'most', 12000, 'bootstrap', 999, 'twins', 400, ...
                    'covariance', 'matern52', 'trend', 'choose', ...
                    'maxNewRuns', 0, 'explore', true, 'neutral', 4, ...
                    'batch', 5, 'batches', 6, 'standsAt', 0.9, ...
                    'standsRuns', 4, 'alikeRuns', 8, 'mostRuns', 12, ...
                    'worthAt', 0.03, 'seekAt', 0.5, 'seekRuns', 10, ...
                    'verifyRuns', 5, ...
                    'level', 0.05, 'nameAt', 0.9, 'groupAt', 0.8, ...
                    'classNats', 6, 'classAt', 0.85, 'vagueRun', 0.25, ...
                    'leastPoints', 200, 'surplus', 1.15, 'caution', 0.4, ...
                    'misfitAt', 0.5, 'turnedAt', 1, 'othersAt', 0.1, ...
                    'alikeAt', 0.7, 'partnerAt', 0.05, 'rivalAt', 0.05, ...
                    'gluedAt', 0.5, 'leftAt', 4, 'confusedAt', 0.1, ...
                    'blindAt', 0.9, 'hiddenAt', 0.9, ...
                    'limitAt', 0.98, 'looMeanAt', 2, 'looMostAt', 5, ...
                    'looEffectAt', 2.5, 'vagueAt', 0.5, 'blameAt', 0.2, ...
                    'conflictAt', 0.01, 'pairAt', 0.2, 'adviseAt', 0.2, ...
                    'testRuns', 120, 'fitMargin', 0.02);
  if isstruct (given)
    fields = fieldnames (given);
    for k = 1:numel (fields)
      options.(fields{k}) = given.(fields{k});
    end
  end
end

%!assert (gapOptions ([]).level, 0.05)
%!assert (gapOptions (struct ('nameAt', 0.7)).nameAt, 0.7)

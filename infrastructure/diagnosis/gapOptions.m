% GAPOPTIONS  Fills the options of a diagnosis with their defaults.
%
% CALL: OPTIONS = gapOptions (GIVEN)
%
%   GIVEN    struct with any of the fields ([] = all defaults)
%   OPTIONS  struct with all of them, and the constants below
%     seed         random numbers start here (1)
%     points       first draw of each integral (400), effective points wanted
%                  (400) and most points drawn (12000): points, effective, most
%     leastPoints  effective points below which no number is believed (200: an
%                  error of 0.07 in the logarithm of the evidence)
%     bootstrap    repetitions of the fit test (999)
%     twins        twins without a gap, drawn from the surrogates, that the gate
%                  compares with (400)
%     covariance   of the baseline Kriging ('matern52'; 'choose' tries more)
%     trend        of the same ('choose')
%     maxNewRuns   parameter sets that the diagnosis may run in all (0)
%     explore      make runs before the verdict (true); without, only those that
%                  verify a cure
%     neutral      sets without an effect that a case runs first, for each
%                  parameter and one (4: fewer make most surrogates vague, and
%                  where four are too few runs that mend them are added)
%     batch        runs between two looks at the evidence (5: fewer cost more
%                  fits, more are chosen on older knowledge)
%     verifyRuns   seeds at each compared set when the cure is checked (5)
%     significance  chance of a false alarm (0.05)
%     seekAt       p of the gate below which it is doubtful that there is no gap
%                  (0.5)
%     surplus      variance of data without a gap over what the budget says
%                  (1.15; at 1 laboratories of formulas alarm in 9 %)
%     caution      power of the likelihood in intervals of strengths (0.4: at 1
%                  they hold that of laboratories of other laws in 66 % where
%                  they should in 90 %; closed study intervalCaution.m)
%     othersAt     share of a named effect's probability that none may have that
%                  explains the data without it (0.1)
%     adviseAt     bits about the kind of cause below which no measurement is
%                  advised, and none sought (0.2: a yes or no that is right in
%                  three of four cases)
%
% See also: diagnoseMatrices, judgeCase

function options = gapOptions (given)
  options = struct ('seed', 1, 'points', 400, 'effective', 400, ...
                    'most', 12000, 'leastPoints', 200, 'bootstrap', 999, ...
                    'twins', 400, 'covariance', 'matern52', 'trend', ...
                    'choose', 'maxNewRuns', 0, 'explore', true, 'neutral', 4, ...
                    'batch', 5, 'verifyRuns', 5, 'significance', 0.05, 'seekAt', 0.5, ...
                    'surplus', 1.15, 'caution', 0.4, 'othersAt', 0.1, ...
                    'adviseAt', 0.2);
  options = mergeFields (constants (), options);
  if isstruct (given)
    options = mergeFields (options, given);
  end
end

% Figures come from docs/gap-figures.md where nothing else is said.
function c = constants ()
  c = runsOfEffects ();
  c = mergeFields (c, verdict ());
  c = mergeFields (c, cureAndGap ());
  c = mergeFields (c, surrogatesToBlame ());
end

function c = runsOfEffects ()
  % batches that a diagnosis foresees: one in ten needs more than five
  c.batches = 6;
  % probability of an effect at which no more runs are made for it: as nameAt
  c.standsAt = 0.9;
  % runs that it and its likeliest rival need for that: with fewer, chance names
  % one in twenty wrongly
  c.standsRuns = 4;
  % runs that it and the effect most like it need, from a cosine of alikeAt on:
  % from there on a bend is known (learnEffect)
  c.alikeRuns = 8;
  % runs of an effect from which on batches add none: its bend is known from
  % eight on
  c.mostRuns = 12;
  % bits about the cause below which a batch is not run: a probability of 0.95
  % that moves by less than 0.02
  c.worthAt = 0.03;
  % neutral sets near the fitted one that a diagnosis wants before it says that
  % there is no gap, where that is doubtful (seekAt)
  c.seekRuns = 10;
  % probability at which a pair of effects gets runs of its own: four runs cost
  % as much as screening one effect
  c.pairAt = 0.2;
  % most runs of tests that the case does not have: of six tests all have eight,
  % the best three twenty, the best two 32 (tryMeasurements)
  c.testRuns = 120;
end

function c = verdict ()
  % probability that the effect takes part at which it is named: chosen on
  % development draws
  c.nameAt = 0.9;
  % probability at which effects are a class or a group
  c.groupAt = 0.8;
  % log of the factor by which an effect may be less likely than the likeliest
  % one and is not told from it yet; for scale, evidence is called very strong
  % from 5 on (Kass and Raftery 1995, J. Am. Stat. Assoc. 90)
  c.classNats = 6;
  % cosine of their marks from which that makes them a class: half of what an
  % error of form makes of one has the tangent to the other
  c.classAt = 0.85;
  % variance that comes with the surrogate of an effect, over all noise, above
  % which it tells nothing between two effects
  c.vagueRun = 0.25;
  % probability of discrepancies at which the cause is off the list: likelier
  % than not
  c.misfitAt = 0.5;
  % tangent of the angle between what an effect does and what its law makes of it
  % from which that is another cause: half of what it does is not its own
  c.turnedAt = 1;
  % cosine from which a partner counts as another cause that explains the data
  % without the named one: half of a signature is the other
  c.alikeAt = 0.7;
  % probability of a pair at which its other member is a partner: what 0.95
  % would not leave out
  c.partnerAt = 0.05;
  % posterior mass at the end of the range of a strength from which this is said:
  % likelier outside than inside
  c.gluedAt = 0.5;
  % chance to mistake one effect for another from which on they are listed together,
  % see describeVerdict
  c.confusedAt = 0.1;
end

function c = cureAndGap ()
  % standard deviations by which DEM runs with the named effect may miss a
  % target, and from which one miss is a gap to close: by chance 1 of 1000 with
  % 16 targets
  c.leftAt = 4;
  % standard deviations by which the fitted model misses the tolerance of a reading of
  % the reference from which it cannot follow that reading: by chance one in fifty that
  % stand at the very tolerance
  c.asideAt = 2;
  % and share of what the parameters move it by which it is missed then: less is the lack
  % of any model (0.08, see emulateChange, within a factor of e), and what a cause does
  % there tells causes apart
  c.asideShare = 1 / 3;
  % share of a target's variance that parameters absorb at which it is a blind
  % spot
  c.blindAt = 0.9;
  % share of a direction that parameters hide from which it tells nothing of a
  % gap to close: as blindAt
  c.hiddenAt = 0.9;
  % share of half its box, or of its range, at which a parameter or a strength is
  % at its limit: closer than a surrogate can tell
  c.limitAt = 0.98;
  % p at which two benches contradict each other: six benches make 15 pairs
  c.conflictAt = 0.01;
  % misfit that a fit may leave because it ends early: ten times the step in log
  % density at which fitHypothesis ends
  c.fitMargin = 0.02;
end

function c = surrogatesToBlame ()
  % mean square of the standardised leave-one-out errors of a target at which its
  % surrogate contradicts its runs: of 40 runs less than 1 in 1000 by chance
  c.looMeanAt = 2;
  % the largest of them
  c.looMostAt = 5;
  % the same mean square for the runs of an effect, from six on: fewer runs
  c.looEffectAt = 2.5;
  % share of the variance that is the surrogates' at which they hide a gap, or
  % that of the likeliest effect's mark at which it needs more runs: more than
  % all else together
  c.vagueAt = 0.5;
  % share of targets with such surrogates at which these are to blame: a few are
  % left to the noise budget
  c.blameAt = 0.2;
end

%!assert ([gapOptions([]).significance, gapOptions([]).nameAt], [0.05, 0.9])
%!assert (gapOptions (struct ('twins', 7)).twins, 7)
%!test
%! % all that a diagnosis reads is there, each once
%! assert (numel (fieldnames (gapOptions ([]))), 53);

% SPDX-License-Identifier: GPL-3.0-only

% MEASURECORRECTION  Answers HOW FAR the gap shrinks once an effect is modelled.
%
% CALL: CURE = measureCorrection (VIEW, SETS, FIRST, GROUP)
%
%   VIEW     struct gapProblem, em, models
%   SETS     struct array of runCorrections: the null model first, then each
%            effect
%   FIRST    effect numbers of the cause, one of SETS
%   GROUP    numbers of effects that are no placebos
%   CURE     struct
%     effect   text, names of the effects that were added
%     before, after, floor, closure, interval90   on the used targets
%     heldOut  the same on the held-out targets ([] if there are none)
%     placebos 1 x m struct effect, closure, heldOut, verifiedByDEM: effects
%              that are not members of the group, refitted alike
%     verifiedByDEM logical: before and after are of DEM runs (a placebo may
%              be of surrogates where the runs ended)
%     worstZ   largest deviation of the DEM mean from the surrogate in standard
%              deviations, NaN: not run
%     params   2 x p, without and with the effect;  phi  1 x h, strengths
%     remaining 1 x n, deviation of each used target after the cure, in its
%       standard deviations
%
% See also: runCorrections, closureOf, diagnoseMatrices

function cure = measureCorrection (view, sets, first, group)
  gapProblem = view.gapProblem;
  em = view.em;
  names = view.models.names;
  at = find (cellfun (@(h) isequal (h, first), {sets.h}), 1);
  noise = diag (noiseBudget (gapProblem, em).covariance)';
  cure = closureAt (view, noise, sets(1).Z, sets(at).Z, gapProblem.used);
  cure.effect = strjoin (names(first), ' + ');
  cure.heldOut = [];
  if ~isempty (gapProblem.heldOut)
    cure.heldOut = closureAt (view, noise, sets(1).Z, sets(at).Z, ...
                              gapProblem.heldOut);
  end
  cure.placebos = struct ('effect', {}, 'closure', {}, 'heldOut', {}, ...
                          'verifiedByDEM', {});
  for i = setdiff (2:numel (sets), at)
    if any (ismember (sets(i).h, group))
      continue
    end
    own = closureAt (view, noise, sets(1).Z, sets(i).Z, gapProblem.used);
    held = NaN;
    if ~isempty (gapProblem.heldOut)
      held = closureAt (view, noise, sets(1).Z, sets(i).Z, ...
                        gapProblem.heldOut).closure;
    end
    cure.placebos(end + 1) = struct ('effect', ...
                                     strjoin (names(sets(i).h), ' + '), ...
                                     'closure', own.closure, ...
                                     'heldOut', held, ...
                                     'verifiedByDEM', sets(i).verified);
  end
  cure.verifiedByDEM = all ([sets([1, at]).verified]);
  cure.worstZ = max ([sets([1, at]).worstZ]);
  half = diff (gapProblem.limits) / 2;
  cure.params = mean (gapProblem.limits) + ...
                [sets(1).Q; sets(at).Q(1:em.p)] .* half;
  cure.phi = sets(at).Q(em.p + 1:end);
  used = gapProblem.used;
  left = gapProblem.value(used) - mean (sets(at).Z(:, used), 1);
  cure.remaining = left ./ sqrt (noise(used));
end

function c = closureAt (view, noise, before, after, at)
  c = closureOf (view.gapProblem.value(at), noise(at), before(:, at), ...
                 after(:, at), view.em.range(at));
end

%!test
%! % a placebo whose runs were cut off takes nothing from a cure that was run
%! [given, data] = smallGapLab ();
%! given.value = mean (data.Z);
%! gapProblem = newGapProblem (given);
%! em = fitEmulator (gapProblem, data, gapOptions ([]));
%! names = arrayfun (@(k) sprintf ('e%d', k), 1:2, 'UniformOutput', false);
%! view = struct ('gapProblem', gapProblem, 'em', em, ...
%!                'models', struct ('names', {names}));
%! set = struct ('h', zeros (1, 0), 'Q', zeros (1, em.p), ...
%!               'Z', data.Z(1:3, :), 'worstZ', 1, 'verified', true);
%! cured = setfield (setfield (set, 'h', 1), 'Q', zeros (1, em.p + 1));
%! cut = setfield (setfield (cured, 'h', 2), 'verified', false);
%! cure = measureCorrection (view, [set, cured, cut], 1, 1);
%! assert (cure.verifiedByDEM);
%! assert ({cure.placebos.effect}, {'e2'});
%! assert (! cure.placebos.verifiedByDEM);
%! cure = measureCorrection (view, [set, cured, cut], 2, 2);
%! assert (! cure.verifiedByDEM);

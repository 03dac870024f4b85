% SIDESIGNALS  Looks for what else a misfit may mean: limits, surrogates.
%
% CALL: SIDE = sideSignals (GAPPROBLEM, EM, THETA)
%
%   GAPPROBLEM, EM  of newGapProblem, fitEmulator
%   THETA           1 x p, fitted null model, parameters in [-1, 1]
%   SIDE            struct
%     atLimit        cellstr, parameters driven to a limit of their box
%     priorConflict  1 x p, deviation from an independently measured value, in
%                    its standard deviations (NaN: none was given)
%     share          1 x T, surrogate part of the variance at THETA
%     poor           1 x T logical, leave-one-out errors larger than claimed:
%                    mean square above 2 or one beyond 5
%     poorEffects    cellstr, effects whose runs contradict their surrogate
%     vague          logical, more than half of the variance of the used targets
%                    is the surrogates'
%     blameSurrogate logical, more than a fifth of the used targets are poor
%     reason         text, '' where neither
%
% See also: locateGap, judgeCase

function side = sideSignals (gapProblem, em, theta)
  half = diff (gapProblem.limits) / 2;
  side.atLimit = gapProblem.names(abs (theta) > 0.98);
  value = mean (gapProblem.limits) + theta .* half;
  side.priorConflict = (value - gapProblem.paramMean) ./ gapProblem.paramSd;
  [~, v] = predictSurrogate (em.surrogates, value);
  v = v + em.fitVar;
  fixed = diag (noiseBudget (gapProblem, em).covariance)';
  side.share = v ./ (v + fixed);
  side.poor = em.looMean > 2 | em.looMax > 5;
  side.poorEffects = poorEffects (em);
  share = mean (side.share(gapProblem.used));
  poor = mean (side.poor(gapProblem.used));
  side.vague = share > 0.5;
  side.blameSurrogate = poor > 0.2;
  side.reason = '';
  if side.blameSurrogate
    side.reason = sprintf (['the surrogates of %.0f %% of the targets ' ...
                            'contradict their own runs'], 100 * poor);
  elseif side.vague
    side.reason = sprintf (['the surrogates cause %.0f %% of the variance; ' ...
                            'more runs near the fitted set are needed'], ...
                           100 * share);
  end
end

function names = poorEffects (em)
  names = {};
  for k = 1:numel (em.effect)
    z = vertcat (em.effect(k).looStd{:});
    if em.effect(k).runs >= 6 && mean (z.^2) > 2.5
      names{end + 1} = em.effect(k).name;
    end
  end
end

%!test
%! rand ('twister', 4); randn ('twister', 4);
%! lab = standInGap (0);
%! given = setfield (lab.gapProblem, 'value', ones (1, 24));
%! given.paramMean = [0.5, NaN, NaN, NaN];
%! given.paramSd = [0.1, NaN, NaN, NaN];
%! gapProblem = newGapProblem (given);
%! em = fitEmulator (gapProblem, lab.plan (40, 2), ...
%!                    gapOptions (struct ('trend', 'affine')));
%! side = sideSignals (gapProblem, em, [1, 0, 0, 0]);
%! assert (side.atLimit, {'friction'});
%! assert (side.priorConflict(1), 5, 1e-9);
%! assert (side.blameSurrogate || side.vague, false);
%! gapProblem.sd = 0.01 * gapProblem.sd;
%! gapProblem.trials = Inf;
%! assert (sideSignals (gapProblem, em, [0, 0, 0, 0]).vague, true);

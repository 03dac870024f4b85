% SIDESIGNALS  Looks for what else a misfit may mean: limits, surrogates.
%
% CALL: SIDE = sideSignals (PROBLEM, EMULATOR, THETA, OPTIONS)
%
%   PROBLEM, EMULATOR, OPTIONS     of newProblem, fitEmulator, gapOptions
%   THETA           1 x p, fitted null model, parameters in [-1, 1]
%   SIDE            struct
%     atLimit        cellstr, parameters driven to a limit of their box
%     share          1 x T, surrogate part of the variance at THETA
%     poor           1 x T logical, leave-one-out errors larger than claimed
%     poorEffects    cellstr, effects whose runs contradict their surrogate
%     vague          logical, the variance of the used targets is mostly that of
%                    the surrogates
%     blameSurrogate logical, too many of the used targets are poor
%     reason         text, '' where neither

function side = sideSignals (problem, emulator, theta, options)
  side.atLimit = problem.names(abs (theta) > options.limitAt);
  % of a change they err alike in both conditions, and cancel
  v = baseVariance (emulator, theta) * isempty (emulator.change);
  fixed = diag (noiseBudget (problem, emulator).covariance)';
  side.share = v ./ (v + fixed);
  side.poor = emulator.looMean > options.looMeanAt | emulator.looMax > options.looMostAt;
  side.poorEffects = poorEffects (emulator, options.looEffectAt);
  share = mean (side.share(problem.used));
  poor = mean (side.poor(problem.used));
  side.vague = share > options.vagueAt;
  side.blameSurrogate = poor > options.blameAt;
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

function names = poorEffects (emulator, most)
  names = {};
  for k = 1:numel (emulator.effect)
    z = vertcat (emulator.effect(k).looStd{:});
    if emulator.effect(k).runs >= 6 && mean (z.^2) > most
      names{end + 1} = emulator.effect(k).name;
    end
  end
end

%!test
%! rand ('twister', 4); randn ('twister', 4);
%! lab = standInGap (0);
%! given = setfield (lab.problem, 'value', ones (1, 24));
%! study = labStudy (given, lab.plan (40, 2));
%! options = study.hypotheses.options;
%! problem = study.problem;
%! side = sideSignals (problem, study.emulator, [1, 0, 0, 0], options);
%! assert (side.atLimit, {'friction'});
%! assert (side.blameSurrogate || side.vague, false);
%! problem.sd = 0.01 * problem.sd;
%! problem.trials = Inf;
%! side = sideSignals (problem, study.emulator, zeros (1, 4), options);
%! assert (side.vague, true);

% SPDX-License-Identifier: GPL-3.0-only

% FORMCASE  Diagnoses one stored case, with its form and with others.
%
% CALL: LINES = formCase (PART, NUMBER, GIVEN, EMULATOR, TRUTH, HOW)
% CALL: HEADER = formCase ()
%
%   PART, NUMBER  text and number of the case
%   GIVEN         for newProblem;  EMULATOR  of fitEmulator
%   TRUTH         struct X (1 x p), phi (1 x K); isUnlisted: the cause is off
%                 the list
%   HOW           struct options (gapOptions), reference (gapReference)
%   LINES         1 x n cell of rows of the table of formStudy
%
% See also: formStudy

function lines = formCase (part, number, given, emulator, truth, how)
  if nargin == 0
    lines = ['part,case,class,cause,tangent,way,d,verdict,effects,class90,', ...
             'pSaid,top,pTop,pTrue,p,pairs,turn,unlisted,decides'];
    return
  end
  lines = {};
  problem = setfield (newProblem (given), 'unit', 1);
  emulator = emulateChange (emulator, problem);
  usable = [emulator.effect.laboratory] | [emulator.effect.runs] >= 3;
  emulator = withoutEffects (emulator, find (~usable));
  hypotheses = makeHypotheses (problem, emulator, how.options);
  [truth, d] = described (problem, hypotheses, truth);
  ways = {'rival', 'smooth'};
  way = ways{1 + mod(number, 2)};
  tangents = 0;
  if strcmp (truth.class, 'single') && d >= 3
    tangents = [0, 0.35, 0.6];
  end
  Y = repmat (problem.value(problem.used), numel (tangents), 1);
  for i = 2:numel (tangents)
    phi = struct ('at', truth.at, 'strength', truth.strength);
    Y(i, :) = Y(i, :) + tangents(i) * ...
                        turnMark (hypotheses, problem, truth.theta, phi, way, ...
                                  7000 + number);
  end
  hypotheses.reference = how.reference;
  fits = fitLibrary (hypotheses, Y);
  for i = 1:numel (tangents)
    own = setfield (problem, 'value', {problem.used}, Y(i, :));
    study = struct ('problem', own, 'emulator', emulator, 'hypotheses', hypotheses, 'fits', ...
                    fits);
    start = sprintf ('%s,%d,%s,%s,%g,%s,%.2f', part, number, truth.class, ...
                     strjoin (truth.names, ' '), tangents(i), way, d);
    lines{end + 1} = [start, answerOf(study, i, truth)];
  end
end

% Turns what a cause makes away from the form of its law: SHIFT (1 x T') is to be added to
% the values of the targets, times the tangent of the angle by which what is seen of the
% cause (the part that parameters cannot absorb, in units of the noise) is to turn. WAY
% 'rival': towards another listed effect, drawn by SEED; 'smooth': along benches and
% curves. The part that is added is at right angles to the mark.
function shift = turnMark (hypotheses, problem, theta, phi, way, seed)
  white = hypotheses.white;
  [~, V, ~, J] = predictGap (white, [], theta);
  sd = sqrt (V);
  slopes = reshape (vertcat (J{:})', numel (V), white.p) ./ sd';
  N = parityProjection (slopes, zeros (numel (V), 1)).N;
  markOf = @(k, strength) seen (white, N, sd, k, [theta, strength]);
  u = markOf (phi.at, phi.strength);
  others = setdiff (1:numel (white.effect), phi.at);
  restore = seedRandom (seed);
  others = others(randperm (numel (others)));
  w = zeros (size (u));
  if strcmp (way, 'smooth')
    others = [];
    w = N' * ((smoothDraw (problem, white) * white.W') ./ sd)';
    w = w - u * (u' * w) / (u' * u);
  end
  for k = others
    v = markOf (k, white.effect(k).range(2));
    w = v - u * (u' * v) / (u' * u);
    if norm (v) > 1 && norm (w) > 0.2 * norm (v)
      break
    end
  end
  w = norm (u) * w / max (norm (w), realmin);
  shift = ((N * w)' .* sd) * white.back';
end

function u = seen (white, N, sd, k, q)
  [~, ~, S] = predictGap (white, k, q);
  u = N' * (S ./ sd)';
end

% Alike along curves (over a third of them) and on benches, in units of the
% uncertainty.
function x = smoothDraw (problem, white)
  at = white.columns;
  bench = problem.bench(at);
  C = 0.5 * (bench' == bench) + 0.1 * eye (numel (at));
  for s = setdiff (problem.series(at), 0)
    own = find (problem.series(at) == s);
    where = problem.coordinate(at)(own);
    apart = abs (where' - where) / max ((max (where) - min (where)) / 3, ...
                                        realmin);
    C(own, own) = C(own, own) + 0.4 * exp (-apart);
  end
  alone = problem.series(at) == 0;
  C = C + 0.4 * diag (alone);
  x = randn (1, numel (at)) * chol (C) .* problem.sd(at);
end

function [truth, d] = described (problem, hypotheses, truth)
  truth.theta = 2 * toUnit (truth.X, problem.limits) - 1;
  names = {problem.effects(abs (truth.phi) > 1e-9).name};
  [isThere, at] = ismember (names, hypotheses.names);
  truth.names = names;
  classes = {'null', 'single', 'pair'};
  truth.class = classes{1 + numel(names)};
  if ~all (isThere) || (isfield (truth, 'isUnlisted') && truth.isUnlisted)
    truth.class = 'unlisted';
  end
  truth.at = at;
  truth.strength = truth.phi(abs (truth.phi) > 1e-9);
  d = 0;
  if any (strcmp (truth.class, {'single', 'pair'}))
    white = hypotheses.white;
    [~, ~, S] = predictGap (white, at, [truth.theta, truth.strength]);
    [~, V, ~, J] = predictGap (white, [], truth.theta);
    slopes = reshape (vertcat (J{:})', numel (V), white.p) ./ sqrt (V');
    N = parityProjection (slopes, zeros (numel (V), 1)).N;
    d = norm (N' * (S ./ sqrt (V))');
  end
end

function text = answerOf (study, i, truth)
  hypotheses = study.hypotheses;
  evidence = caseEvidence (hypotheses, study.fits, i);
  verdict = judgeCase (evidence, hypotheses);
  [class90, decides] = deal (verdict.effects, {});
  if isfield (verdict, 'class')
    [verdict, decides] = withoutReadings (verdict, study);
    class90 = verdict.class;
  end
  holding = @(set) sum (verdict.P(cellfun (@(m) any (ismember (m, set)), ...
                                           evidence.members)));
  said = [arrayfun(holding, verdict.effects), 1];
  if strcmp (verdict.kind, 'group')
    said = holding (verdict.effects);
  end
  pTrue = 0;
  if any (strcmp (truth.class, {'single', 'pair'}))
    pTrue = max (arrayfun (holding, truth.at));
  end
  isPair = strcmp (evidence.kind, 'pair');
  text = sprintf (',%s,%s,%s,%.4f,%s,%.4f,%.4f,%.3g,%.4f,%.2f,%.4f,%s', ...
                  verdict.kind, ...
                  strjoin (hypotheses.names(verdict.effects), ' '), ...
                  strjoin (hypotheses.names(class90), ' '), min (said), ...
                  hypotheses.names{verdict.top}, holding (verdict.top), pTrue, ...
                  evidence.gate.p, sum (verdict.P(isPair)), turnOf (evidence), ...
                  verdict.unlisted, strjoin (decides, ' '));
end

% Of the likeliest hypothesis with effects the tangent of its form error.
function t = turnOf (evidence)
  logP = evidence.logPrior + evidence.logE - 1e9 * cellfun (@isempty, evidence.members);
  [~, best] = max (logP);
  t = NaN;
  if ~isempty (evidence.posterior{best}.Q)
    t = weightedQuantile (evidence.posterior{best}.Q(:, end), ...
                          evidence.posterior{best}.weight, 0.5);
  end
end

% SPDX-License-Identifier: GPL-3.0-only

% WEIGHCURES  Lets the runs of the cures decide which effect it is.
%
% CALL: [VERDICT, W] = weighCures (VERDICT, W, VIEW, DATA)
%
%   VERDICT, W  of judgeCase, weighCase before the cures were run
%   VIEW        struct problem, em, models, as of runCures
%   DATA        all runs, those of the cures among them
%   VERDICT, W  the same with these runs known and the held-out targets in the
%               evidence; VERDICT.before: probability of each effect before
%
% The runs stand where each effect would have to be, so they are the best runs
% of it; the held-out targets were never fitted. The evidence of all targets is
% that of the used ones times the predictive density of the held-out ones, p
% (held | used): the Bayes factor of the predictions. Whether there is a gap was
% decided before.
%
% See also: runCures, judgeCase

function [verdict, w] = weighCures (verdict, w, view, data)
  problem = view.problem;
  options = view.models.options;
  em = fitEmulator (problem, data, options, view.em);
  em.effect = em.effect(ismember ({em.effect.name}, view.models.names));
  targets = sort ([problem.used, problem.heldOut]);
  models = makeModels (problem, em, options, targets);
  models.reference = view.models.reference;
  fits = fitLibrary (models, problem.y(targets));
  before = verdict.total;
  gate = w.gate;
  w = weighCase (models, fits, 1);
  w.gate = gate;
  verdict = judgeCase (w, models);
  verdict.before = before;
end

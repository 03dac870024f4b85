% CORRECTIONEVIDENCE  Lets the runs of the cures decide which effect it is.
%
% CALL: [VERDICT, W] = correctionEvidence (VERDICT, W, VIEW, DATA)
%
%   VERDICT, W  of judgeCase, caseEvidence before the cures were run
%   VIEW        struct gapProblem, em, models, as of runCorrections
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
% See also: runCorrections, judgeCase

function [verdict, w] = correctionEvidence (verdict, w, view, data)
  gapProblem = view.gapProblem;
  options = view.models.options;
  em = fitEmulator (gapProblem, data, options, view.em);
  em.effect = em.effect(ismember ({em.effect.name}, view.models.names));
  targets = sort ([gapProblem.used, gapProblem.heldOut]);
  models = makeHypotheses (gapProblem, em, options, targets);
  models.reference = view.models.reference;
  fits = fitLibrary (models, gapProblem.value(targets));
  before = verdict.total;
  gate = w.gate;
  w = caseEvidence (models, fits, 1);
  w.gate = gate;
  verdict = judgeCase (w, models);
  verdict.before = before;
end

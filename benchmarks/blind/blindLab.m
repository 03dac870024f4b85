% BLINDLAB  What the sealed laboratory knows of the benches: a campaign.
%
% CALL: LAB = blindLab (ROOT, BENCHES)
%
%   ROOT     folder of the toolbox
%   BENCHES  cellstr, benches on which is measured (default: all)
%   LAB   struct: trials (3: each value is the mean of so many), sd (1 x T,
%         reading error of one trial), gapProblem (of newGapProblem), models (of
%         makeHypotheses, from the stored campaign hiddenEffect), em
%         (fitEmulator)
%
% It serves to choose strengths and to say how detectable a truth is. The
% diagnosis gets runs and measured values, nothing of this.
%
% See also: blindDraw, blindSpace, blindHeld, storedCampaign

function lab = blindLab (root, benches)
  [given, data] = storedCampaign ('hiddenEffect', root);
  lab = struct ('trials', 3, 'sd', given.sd);
  given.held = ismember (given.targetNames, blindHeld ());
  if nargin > 1
    isThere = ismember (given.benchNames, benches);
    given.value(~isThere(given.bench)) = NaN;
  end
  given.trials = lab.trials;
  given.sd = given.sd / sqrt (lab.trials);
  options = gapOptions ([]);
  lab.gapProblem = newGapProblem (given);
  lab.em = fitEmulator (lab.gapProblem, data, options);
  lab.models = makeHypotheses (lab.gapProblem, lab.em, options);
end

% BLINDLAB  What the sealed laboratory knows of the benches: a campaign.
%
% CALL: LAB = blindLab (ROOT, STEM)
%
%   ROOT  folder of the toolbox
%   STEM  path or name of the study. Ends it in 'bins', the laboratory has drum
%         and slot bins (campaign drumAndBins, two trials); else collapse, shear
%         cell and heap (campaign hiddenEffect, three trials)
%   LAB   struct: trials (each value is the mean of so many), sd (1 x T,
%         reading error of one trial), problem (of newProblem), hypotheses (of
%         makeHypotheses, from the stored campaign), emulator (fitEmulator), and
%     shares    struct, share of each class of blindDraw; the rest: lookAlike
%     forms     cellstr, what of blindForms it can do
%     runs      path of the campaign that its cases share
%     inputs    path of the loadInput.m of its cases
%     renamed   n x 3 cell: name of a result in the campaign, in runs.csv and in
%               measured.csv of a case (parts of names)
%
% It serves to choose strengths and to say how detectable a truth is. The
% diagnosis gets runs and measured values, nothing of this.
%
% See also: blindDraw, blindSpace, storedCampaign

function lab = blindLab (root, stem)
  own = fullfile (root, 'benchmarks', 'blind');
  lab = struct ('trials', 3, 'forms', {ofTable()}, ...
                'shares', struct ('null', 0.3, 'single', 0.4, ...
                                  'pair', 0.1, 'unlisted', 0.1), ...
                'runs', fullfile (own, 'storedRuns.csv'), ...
                'inputs', fullfile (own, 'case', 'loadInput.m'), ...
                'renamed', {{'collapseSlope', 'Collapse_slope', 'slope'; ...
                             'heapSlope', 'Heap_slope', 'slope'; ...
                             'heapHeight', 'height', 'height'}});
  campaign = 'hiddenEffect';
  if regexp (stem, 'bins(-whole)?$')
    campaign = 'drumAndBins';
    lab = ofBins (lab, root);
  end
  [given, data] = storedCampaign (campaign, root);
  lab.sd = given.sd;
  % never fitted, more than a quarter of each bench: how far a cure closes the gap
  % is seen on them
  held = {'heightFoot', 'spreadTime', 'densityHigh', 'massOnPlate'};
  given.held = ismember (given.targetNames, held);
  given.trials = lab.trials;
  given.sd = given.sd / sqrt (lab.trials);
  options = gapOptions ([]);
  lab.problem = newProblem (given);
  lab.emulator = fitEmulator (lab.problem, data, options);
  lab.hypotheses = makeHypotheses (lab.problem, lab.emulator, options);
end

function names = ofTable ()
  forms = blindForms ();
  names = setdiff ({forms.name}, {'slotsByLength', 'widerBatch', ...
                                  'wideSizes', 'wet', 'stickyWalls'});
end

% More causes that are on no list than at the other benches. Clumps block the
% slots (benchmarks/drumAndBins/README.md).
function lab = ofBins (lab, root)
  folder = fullfile (root, 'benchmarks', 'drumAndBins');
  lab.trials = 2;
  lab.shares = struct ('null', 0.25, 'single', 0.375, 'pair', 0.085, ...
                       'unlisted', 0.145);
  lab.forms = {'sjkr2', 'squareDrag', 'slowVibration', 'slotsByLength', ...
               'widerBatch', 'cdt', 'hooke', 'soft', 'wideSizes', 'wet', ...
               'stickyWalls'};
  lab.runs = fullfile (folder, 'storedRuns.csv');
  lab.inputs = fullfile (root, 'benchmarks', 'blind', 'bins', 'loadInput.m');
  lab.renamed = {'drumSlope3', 'slope3', 'slope3'; ...
                 'drumSlope', 'Drum_slope', 'slope'; ...
                 'binSlope', 'SlotBin_slope', 'slope'};
end

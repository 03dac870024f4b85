% LEFTOUTCAMPAIGN  Loads a stored campaign for the study of left-out runs.
%
% CALL: CAMPAIGN = leftOutCampaign (NAME, ROOT)
%
%   NAME      'hiddenEffect' (examples/) or 'drumAndBins' (benchmarks/)
%   ROOT      folder of the toolbox
%   CAMPAIGN  struct name, given (for newProblem; nothing is held out), data
%             (all runs), emulator (fitEmulator on all), reference (of
%             gapReference), isWhole (1 x n logical: every result is there)
%
% See also: leftOut

function campaign = leftOutCampaign (name, root)
  [given, data] = storedCampaign (name, root);
  given.held(:) = false;
  problem = newProblem (given);
  options = gapOptions ([]);
  emulator = fitEmulator (problem, data, options);
  hypotheses = gapReference (makeHypotheses (problem, emulator, options));
  campaign = struct ('name', name, 'given', given, 'data', data, 'emulator', emulator, ...
                     'reference', hypotheses.reference, ...
                     'isWhole', all (isfinite (data.Z), 2)');
end

% SPDX-License-Identifier: GPL-3.0-only

% STOREDCAMPAIGN  Loads the stored runs of a campaign and what they mean.
%
% CALL: [GIVEN, DATA] = storedCampaign (NAME, ROOT)
%
%   NAME   case in examples/ or benchmarks/; its runs: storedRuns.csv
%   ROOT   folder of the toolbox
%   GIVEN  struct for newGapProblem;  DATA  all runs, see importRuns
%
% See also: leftOutCampaign

function [given, data] = storedCampaign (name, root)
  folder = fullfile (root, 'examples', name);
  if ~isfolder (folder)
    folder = fullfile (root, 'benchmarks', name);
  end
  % Octave looks for loadInput.m in the working folder first
  before = enter (folder);
  back = onCleanup (@() enter (before));
  Case = withEffects (loadCase (root, folder));
  data = importRuns (fullfile (folder, 'storedRuns.csv'), Case);
  given = gapProblemOf (Case);
end

% What was loaded in another folder would stay: Octave does not look again.
function before = enter (folder)
  before = cd (folder);
  clear ('-f', 'loadInput', 'loadEffects');
end

%!test
%! root = startBenchmarks ();
%! here = pwd ();
%! [~, own] = loadInput ();
%! [given, data] = storedCampaign ('hiddenEffect', root);
%! [~, after] = loadInput ();
%! assert (isequal (after.targetVal, own.targetVal));
%! assert (pwd (), here);
%! assert (size (data.Z), [153, 14]);
%! assert (numel (given.effects), 12);

%!test
%! % one campaign after another
%! root = startBenchmarks ();
%! storedCampaign ('hiddenEffect', root);
%! [given, data] = storedCampaign ('drumAndBins', root);
%! assert (numel (given.sd), columns (data.Z));

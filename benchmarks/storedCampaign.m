% STOREDCAMPAIGN  Loads the stored runs of a campaign and what they mean.
%
% CALL: [GIVEN, DATA] = storedCampaign (NAME, ROOT)
%
%   NAME   case in examples/ or benchmarks/; its runs: storedRuns.csv
%   ROOT   folder of the toolbox
%   GIVEN  struct for newProblem;  DATA  all runs, see importRuns
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
  given = newProblem (Case);
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

%!shared given, data, phi
%! % one campaign after another
%! root = startBenchmarks ();
%! storedCampaign ('hiddenEffect', root);
%! [given, data] = storedCampaign ('drumAndBins', root);
%! phi = strengthOfValues (newProblem (given).effects, data.E);
%!test
%! assert (given.benchNames, {'Drum', 'SlotBin'});
%! assert (given.bench, [ones(1, 9), 2 * ones(1, 6)]);
%! assert (numel (unique (given.targetNames)), 15);
%! assert (numel (given.effects), 10);
%! assert (given.names, {'densityP', 'coefFrictionPP', 'coefFrictionPW', ...
%!                       'coefRollingFrictionPP'});
%!test % 45 neutral sets and six second packings, 12 sets an effect, 12 pairs
%! assert (size (data.Z), [159, 15]);
%! on = phi ~= 0;
%! alone = sum (on, 2) == 1;
%! assert (sum (~any (on, 2)), 51);
%! assert (sum (data.replicate == 2), 6);
%! assert (sum (on(alone, :)), [12 * ones(1, 8), 0, 0]);
%! assert (sum (sum (on, 2) == 2), 12);
%!test % every run has all its results; clumps were run in the drum alone
%! isShape = phi(:, strcmp ({given.effects.name}, 'shape')) ~= 0;
%! assert (isfinite (data.Z(:, given.bench == 1)));
%! assert (isfinite (data.Z(:, given.bench == 2)), repmat (~isShape, 1, 6));
%!test % the runs lie in the box and at the strengths of the plan
%! lims = given.limits;
%! assert (all (data.X >= lims(1, :) & data.X <= lims(2, :)));
%! on = abs (phi(phi ~= 0));
%! assert (min (on) >= 0.15 - 1e-12 && max (on) <= 1 + 1e-12);

% SPDX-License-Identifier: GPL-3.0-only

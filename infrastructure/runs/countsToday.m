% COUNTSTODAY  Tells whether a stored run is one that the case asks for today.
%
% CALL: EFFECTS = countsToday (JOB, FOLDER, CASE, H)
%
%   JOB      job or record of the run, see newJobs; may be []
%   FOLDER   its folder (text)
%   CASE     see newCase
%   H        element of hashModels for its model
%   EFFECTS  {} where it is none; else {1 x v}: levels and effect values under
%            which its key is what the case gives
%
% A run of the plain model counts under any list of effects, a run with an
% effect under any list that holds it: its data.head says which it was.

function effects = countsToday (job, folder, Case, h)
  effects = {};
  if isempty (job) || numel (job.params) ~= numel (Case.names)
    return
  end
  neutral = neutralEffects (Case);
  trials = {@() neutral, @() effectsInHead(folder, Case, neutral)};
  if numel (job.effects) == numel (neutral)
    % most often the list is as it was: no file need be read then
    trials = [{@() reshape(job.effects, 1, [])}, trials];
  end
  for k = 1:numel (trials)
    trial = job;
    trial.effects = trials{k}();
    if strcmp (job.key, runKey (runVariables (trial, Case), Case.effectVars, h))
      effects = {trial.effects};
      return
    end
  end
end

function values = effectsInHead (folder, Case, values)
  file = fullfile (folder, 'data.head');
  if ~isfile (file)
    return
  end
  head = headDefaults (file);
  for j = 1:numel (values)
    values(j) = givenField (head, Case.effectVars{j}, values(j));
  end
end

%!test
%! Case = readyCase ();
%! job = newJobs (Case, [1, 2], [], 1, 'plan')(1);
%! h = hashModels (Case)(1);
%! assert (countsToday (job, '', Case, h), {zeros(1, 0)});
%! % a level that its record does not tell: data.head does
%! own = struct ('variable', 'e', 'levels', [0.4, 0]);
%! Case.coarse = setfield (own, 'models', [1, 2]);
%! Case.effectVars = {'e'};
%! job = newJobs (Case, [1, 2], 0.4, 1, 'plan')(1);
%! folder = prepareRun (job, Case);
%! job.effects = [];
%! assert (countsToday (job, folder, Case, h), {0.4});
%! Case.modelVars.c = 3;
%! assert (countsToday (job, folder, Case, h), {});

% SPDX-License-Identifier: GPL-3.0-only

% COUNTSTODAY  Tells whether a stored run is one that the case asks for today.
%
% CALL: YES = countsToday (JOB, CASE, H)
%
%   JOB   job or record of the run, see newJobs
%   CASE  see newCase
%   H     element of hashModels for its model
%   YES   its key is what the case gives; a run without effects counts under any
%         list of effects

function yes = countsToday (job, Case, h)
  yes = false;
  if numel (job.params) ~= numel (Case.names)
    return
  end
  given = reshape (job.effects, 1, []);
  neutral = neutralEffects (Case);
  trials = {neutral};
  levels = numel (Case.coarse);
  if levels > 0 && numel (given) == levels
    trials{2} = [given, neutral(levels + 1:end)];   % a run of a calibration
  end
  if numel (given) == numel (neutral)
    trials{end + 1} = given;
  end
  for k = 1:numel (trials)
    job.effects = trials{k};
    [key, older] = runKey (runVariables (job, Case), Case.effectVars, h);
    yes = yes || any (strcmp (job.key, {key, older}));
  end
end

%!test
%! Case = newCase (standInCase (tempname ()));
%! job = newJobs (Case, [1, 2], [], 1, 'plan')(1);
%! h = hashModels (Case)(1);
%! assert (countsToday (job, Case, h));
%! Case.modelVars.c = 3;
%! assert (~countsToday (job, Case, h));

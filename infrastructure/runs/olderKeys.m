% OLDERKEYS  Keys that earlier versions gave to the run that a job asks for.
%
% CALL: KEYS = olderKeys (JOB, CASE, H)
%
%   JOB   see newJobs;  CASE  see newCase
%   H     element of hashModels for its model
%   KEYS  1 x n cell of texts
%
% Until 0.9 sets were not rounded to 15 digits, nor their seeds drawn of the
% rounded ones.

function keys = olderKeys (job, Case, h)
  [~, keys] = runKey (runVariables (job, Case), Case.effectVars, h);
  drawn = givenField (job, 'drawn', []);
  if ~isempty (drawn)
    d = numel (job.params);
    job.params = drawn(1:d);
    job.effects = drawn(d + 1:end);
    job.seed = jobSeed (job, Case);
    [~, older] = runKey (runVariables (job, Case), Case.effectVars, h);
    keys = [keys, older];
  end
end

%!test
%! % of a set with 17 digits: its values and its seed as they were
%! Case = newCase (standInCase (tempname ()));
%! h = setfield (hashModels (Case)(1), 'older', {});
%! job = newJobs (Case, [1, 2], [], 1, 'plan')(1);
%! assert (olderKeys (job, Case, h), cell (1, 0));
%! p = [1/3, 2];
%! job = newJobs (Case, p, [], 1, 'plan')(1);
%! was = sprintf ('%s|a=%.17g|b=2|runSeed=%d', h.input, 1/3, ...
%!                runSeed (p, 1, Case.options.seed));
%! assert (any (strcmp (hash ('sha256', was), olderKeys (job, Case, h))));
%! assert (job.params, [0.333333333333333, 2]);

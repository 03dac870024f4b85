% WAITING  Processor time that Octave takes while runs are under way.
%
% CALL: octave-cli benchmarks/waiting.m [LENGTHS]
%
% LENGTHS  length of a run (s), e.g. 3,30,150
%
% Stand-in runs that sleep, two at a time, four of each length. What Octave
% needs meanwhile (start, looks, evaluation) is divided by the length of all
% runs: the share of the DEM's core time that is not DEM. Prints a table and
% writes benchmarks/results/waiting.csv.
%
% See also: executeLocal, lookAfter, makespan

1;

function [seconds, work] = octaveTime (span)
  folder = tempname ();
  raw = standInCase (folder);
  writeAtomic (fullfile (folder, 'DEMmodels', 'First', 'runscript'), ...
               sprintf ("sleep %g\necho 1 > out\necho 2 >> out\n", span));
  Case = newCase (raw);
  jobs = newJobs (Case, (1:4)' * [1, 1], [], 1, 'plan');
  jobs = jobs(strcmp ({jobs.model}, 'First'));
  start = cputime ();
  records = executeLocal (jobs, Case, @(s) []);
  seconds = cputime () - start;
  work = sum ([records.seconds]);
end

history_save (false);
addpath (fileparts (mfilename ('fullpath')));
root = startBenchmarks ();
lengths = [3, 30, 150];
if ~isempty (argv ())
  lengths = str2num (argv (){end});
end
table = zeros (0, 4);
printf ('| length of a run | Octave, a run | share |\n|---|---|---|\n');
for span = lengths
  [seconds, work] = octaveTime (span);
  table(end + 1, :) = [span, seconds / 4, work / 4, seconds / work];
  printf ('| %g s | %.2f s | %.2f %% |\n', span, seconds / 4, ...
          100 * seconds / work);
end
writeMatrix (fullfile (root, 'benchmarks', 'results', 'waiting.csv'), ...
             table, {'length', 'octaveSeconds', 'runSeconds', 'share'});

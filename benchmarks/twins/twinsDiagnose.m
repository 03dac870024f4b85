% TWINSDIAGNOSE  Diagnoses every twin from its observables alone.
%
% CALL: VERDICTS = twinsDiagnose (LABS, TWINS)
%
%   LABS, TWINS  of twinsLaboratories, twinsDraw; of TWINS only lab, removed
%                (the list is shorter then) and y are looked at
%   VERDICTS     1 x n struct: kind, effects, top, named (cellstr), P (1 x (K +
%                3): null, each effect, pairs, unlisted), interval (K x 3:
%                strength of each effect, median and 90 %), gateP, fitP,
%                seconds, temperature, nameAt, expected
%
% One emulator and one calibration of the verdict a laboratory; the laboratories
% are shared out to the cores.
%
% See also: weighCase, judgeCase, twins

function verdicts = twinsDiagnose (labs, twins)
  n = numel (labs);
  [jobs, own] = deal (cell (1, n));
  for l = 1:n
    at = find ([twins.lab] == l);
    jobs{l} = struct ('name', labs(l).name, 'problem', labs(l).problem, ...
                      'em', labs(l).em, 'middle', mean (labs(l).data.Z));
    own{l} = struct ('index', at, 'removed', [twins(at).removed], ...
                     'Y', vertcat (twins(at).y));
  end
  parts = parcellfun (min (n, nproc ()), @twinsOfLab, jobs, own, ...
                      'UniformOutput', false, 'VerboseLevel', 0);
  for l = 1:n
    verdicts(own{l}.index) = parts{l};
    first = parts{l}(1);
    printf ('%s: temperature %.1f, names at %.2f, expected right %.2f\n', ...
            labs(l).name, first.temperature, first.nameAt, first.expected);
  end
end

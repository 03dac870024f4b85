% SPLITTOCPU  How many DEM runs at once, and how many each process gets.
%
% CALL: [NUMPROC, RUNSPERCPU, REMAINDER] = SplitToCPU (MAXCPU, NRUNS, NCPURUN)
%
%   MAXCPU      CPUs to be used in all
%   NRUNS       number of runs
%   NCPURUN     CPUs of one run
%   NUMPROC     runs at once
%   RUNSPERCPU  runs each process carries out one after the other
%   REMAINDER   runs left over; NUMPROC RUNSPERCPU + REMAINDER = NRUNS
%
% Errors: DEcalioc:SplitToCPU:badValue
%
% See also: SplitExPlan, executeStatic

function [numProc, runsPerCPU, remainder] = SplitToCPU (maxCPU, nRuns, nCPURun)
  numProc = min (fix (maxCPU / nCPURun), nRuns);
  if numProc < 1
    error ('DEcalioc:SplitToCPU:badValue', ...
           ['SplitToCPU: a run of %g CPUs and %g runs do not fit %g CPUs. ' ...
            'Raise Input.maxCPU or lower Input.cpu.'], nCPURun, nRuns, maxCPU);
  end
  runsPerCPU = fix (nRuns / numProc);
  remainder = rem (nRuns, numProc);
end

%!test
%! [n, per, rest] = SplitToCPU (8, 21, 1);
%! assert ([n, per, rest], [8, 2, 5]);
%! [n, per, rest] = SplitToCPU (8, 3, 2);
%! assert ([n, per, rest], [3, 1, 0]);
%!error id=DEcalioc:SplitToCPU:badValue SplitToCPU (1, 5, 2)

% SPDX-License-Identifier: GPL-3.0-only

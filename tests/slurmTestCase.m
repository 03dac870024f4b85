% SLURMTESTCASE  A case of one formula model whose runs take a while.
%
% CALL: [CASE, JOBS] = slurmTestCase (FOLDER, A, SECONDS)
%
%   FOLDER   folder of the case (text); may be there already
%   A        1 x n, first design variable of the runs; 7: the results are NaN,
%            8: the run hangs, 9: it fails
%   SECONDS  what a run takes (s)
%   CASE     see newCase
%   JOBS     1 x n struct array, see newJobs
%
% Every start of a run writes a line to <store>/optim/First/starts: its folder
% and the node.
%
% See also: standInCase, slurmTestStart

function [Case, jobs] = slurmTestCase (folder, a, seconds)
  raw = standInAt (folder);
  raw.Input.model = {'First'};
  raw.Input.cpu = 1;
  raw.Input.maxCPU = 8;
  raw.optim.targetVal = {[400, 0.025]};
  raw.optim.tolRes = {[0.01, 0.01]};
  file = fullfile (folder, 'DEMmodels', 'First', 'runscript');
  formula = fileread (file);
  if isempty (strfind (formula, 'starts'))
    head = {'echo "$PWD ${SLURMD_NODENAME:-}" >> ../starts', ...
            'a=$(awk ''$2 == "a" { a = $4 } END { print a }'' data.head)', ...
            'case $a in', '  7) printf "nan\nnan\n" > out; exit ;;', ...
            '  8) sleep 300 ;;', ...
            '  9) echo "ERROR: too dense"; exit 3 ;;', 'esac', ...
            sprintf('sleep %g', seconds), formula};
    writeAtomic (file, strjoin (head, "\n"));
  end
  Case = newCase (raw);
  Case.options.slurm = struct ('poll', 0.4, 'grace', 2, ...
                               'maxInFlight', 6);
  P = [a(:), linspace(1, 2, numel (a))'];
  jobs = newJobs (Case, P, [], 1, 'plan');
end

function raw = standInAt (folder)
  scratch = tempname ();
  raw = standInCase (scratch);
  if ~isfolder (folder)
    mkdir (folder);
    rename (fullfile (scratch, 'DEMmodels'), fullfile (folder, 'DEMmodels'));
  end
  raw.folder = folder;
  confirm_recursive_rmdir (false, 'local');
  rmdir (scratch, 's');
end

% SPDX-License-Identifier: GPL-3.0-only

% SLURMTESTONCE  Does something once, when enough runs are under way.
%
% CALL: slurmTestOnce (STATE, ENOUGH, FOLDER, DEED)
%
%   STATE   what batchExecute reports
%   ENOUGH  number of running runs
%   FOLDER  of the test case: the file `meddled` there says that it is done
%   DEED    function handle without arguments
%
% See also: slurmTestCase

function slurmTestOnce (state, enough, folder, deed)
  mark = fullfile (folder, 'meddled');
  if state.running >= enough && ~isfile (mark)
    fclose (fopen (mark, 'w'));
    deed ();
  end
end

% SPDX-License-Identifier: GPL-3.0-only

% COMMANDCASE  A case of two formulas whose runs end only when they may.
%
% CALL: FOLDER = commandCase (BASE, NAME)
%
%   BASE, NAME  where it is made, and its name
%   FOLDER      of the case: no run ends while there is a file hold in it
%
% See also: standInCase, startAside

function folder = commandCase (base, name)
  folder = fullfile (base, name);
  standInCase (folder);
  writeLoadInput (folder, ['optim.tolRes = {[0.05, 0.05], 0.1}; ', ...
                           'optim.maxFunEvals = 8; Input.replicates = 1;']);
  for model = {'First', 'Second'}
    file = fullfile (folder, 'DEMmodels', model{1}, 'runscript');
    hold = shellQuote (fullfile (folder, 'hold'));
    writeAtomic (file, ['while [ -e ', hold, " ]; do sleep 0.1; done\n", ...
                        fileread(file)]);
  end
end

%!test
%! base = emptyFolder ();
%! folder = commandCase (base, 'it''s here');
%! text = fileread (fullfile (folder, 'DEMmodels', 'First', 'runscript'));
%! assert (strncmp (text, 'while [ -e ', 11));

% SPDX-License-Identifier: GPL-3.0-only

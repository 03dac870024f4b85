% SITUATIONPAGE  The page data of a stored situation, and its console.
%
% CALL: [PAGE, TEXT] = situationPage (NAME)
%
%   NAME  name of a situation, see verdictCase
%   PAGE  see pageData: no run, no surrogate
%   TEXT  see verdictConsole
%
% See also: verdictCase, verdictConsole

function [page, text] = situationPage (name)
  list = verdictCase ();
  raw = standInCase (tempname ());
  raw.optim.targetName = {{'sum', 'product'}, {'difference'}};
  Case = newCase (raw);
  situation = list(strcmp ({list.name}, name));
  verdictCase (raw.folder, situation);
  page = pageData (Case);
  if nargout > 1
    text = verdictConsole (situation, Case);
  end
  confirm_recursive_rmdir (false, 'local');
  rmdir (raw.folder, 's');
end

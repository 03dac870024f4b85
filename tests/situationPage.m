% SITUATIONPAGE  The page data of a stored situation, and its console.
%
% CALL: [PAGE, CASE] = situationPage (NAME)
%
%   NAME  name of a situation, see verdictCase
%   PAGE  see pageData: no run, no surrogate;  CASE  see newCase
%
% See also: verdictCase, verdictConsole

function [page, Case] = situationPage (name)
  list = verdictCase ();
  raw = standInCase (tempname ());
  raw.optim.targetName = {{'sum', 'product'}, {'difference'}};
  Case = newCase (raw);
  verdictCase (raw.folder, list(strcmp ({list.name}, name)));
  page = pageData (Case);
  confirm_recursive_rmdir (false, 'local');
  rmdir (raw.folder, 's');
end

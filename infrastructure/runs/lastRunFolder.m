% LASTRUNFOLDER  The run folder of a model with the highest number.
%
% CALL: [NUMBER, NAME] = lastRunFolder (BASE, MODEL)
%
% BASE    folder that holds optim/ (text)
% MODEL   name of the model (text)
% NUMBER  its number, 0 where there is none yet
% NAME    its name (text), '' where there is none yet

function [number, name] = lastRunFolder (base, model)
  names = listRunFolders (base, model);
  number = 0;
  name = '';
  if ~isempty (names)
    numbers = str2double (regexp (names, '^\d+', 'match', 'once'));
    [number, last] = max (numbers);
    name = names{last};
  end
end

%!test
%! base = tempname ();
%! mkdir (fullfile (base, 'optim', 'M', '0009'));
%! mkdir (fullfile (base, 'optim', 'M', '0010_old'));
%! [number, name] = lastRunFolder (base, 'M');
%! confirm_recursive_rmdir (false, 'local');
%! rmdir (base, 's');
%! assert (number, 10);
%! assert (name, '0010_old');
%!test
%! [number, name] = lastRunFolder ('/nowhere', 'M');
%! assert (number, 0);
%! assert (name, '');

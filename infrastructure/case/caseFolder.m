% CASEFOLDER  The folder whose case is meant.
%
% CALL: FOLDER = caseFolder (ROOT)
%
%   ROOT    folder of the toolbox (text)
%   FOLDER  the folder Octave works in; only where Octave's own command run
%           has moved there, the folder Octave was started in, if that holds
%           a loadInput.m
%
% See also: DEcalioc

function folder = caseFolder (root)
  folder = pwd ();
  wasMoved = any (strcmp ({dbstack().name}, 'run')) && strcmp (folder, root);
  start = getenv ('PWD');
  if wasMoved && isfile (fullfile (start, 'loadInput.m'))
    folder = start;
  end
end

%!assert (caseFolder ('/nowhere'), pwd ())

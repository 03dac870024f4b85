% GETEFFECT  Description of one effect of the library.
%
% CALL: EFFECT = getEffect (NAME)
%       EFFECT = getEffect (NAME, FOLDERS)
%
% NAME     name of the effect, as listEffects gives it
% FOLDERS  text or cell of folders that are looked in before the library
% EFFECT   scalar struct, see describeEffect
%
% Throws DEcalioc:getEffect:unknownName.
%
% See also: describeEffect, listEffects, resolveEffects
function effect = getEffect (name, folders)
  if nargin < 2
    folders = {};
  end
  [names, files] = listEffects (folders);
  k = find (strcmp (names, name));
  if isempty (k)
    error ('DEcalioc:getEffect:unknownName', ...
           'getEffect: NAME must be one of %s, got %s.', ...
           strjoin (names, ', '), name);
  end
  [folder, base] = fileparts (files{k});
  if ~any (strcmp (strsplit (path (), pathsep ()), folder))
    addpath (folder);
    restore = onCleanup (@() rmpath (folder));
  end
  effect = feval (base);
end

%!test
%! e = getEffect ('cohesion');
%! assert (e.variables, {'cohesionPP'});
%! assert (e.neutral, 0);

%!test % every file of the library describes the effect of its name
%! for name = listEffects ()
%!   assert (getEffect (name{1}).name, name{1});
%! end

%!test % a file in a folder that is not on the path
%! folder = emptyFolder ();
%! file = fullfile (folder, 'effectTrialOfGetEffect.m');
%! fid = fopen (file, 'w');
%! fputs (fid, ["function e = effectTrialOfGetEffect ()\n", ...
%!   "e = describeEffect (struct ('name', 'trialOfGetEffect', ", ...
%!   "'variables', {{'q'}}, 'neutral', 0, 'limits', [0; 2]));\nend\n"]);
%! fclose (fid);
%! e = getEffect ('trialOfGetEffect', folder);
%! delete (file);
%! rmdir (folder);
%! assert (e.priorScale, 4);

%!error id=DEcalioc:getEffect:unknownName getEffect ('noSuchEffect')

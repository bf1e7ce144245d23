#ifndef FinePeels_h
#define FinePeels_h

class vtkOpenGLRenderPass;

/// VTK's dual depth peeling keeps what it has peeled in 8 bits a channel, colour and what still
/// comes through alike, and rounds at every peel: with six layers a picture is 3 of 255 off, and
/// what is less opaque than 1/510 counts as nothing, so that peeling ends before what is behind it.
/// This gives a pass that is about to peel 16 bits: 16 bytes a pixel more, until its window changes
/// size. It is called inside a mapper's Render and does nothing in any other pass or stage. RENDER
/// thread, with the context current.
void UseFinePeels(vtkOpenGLRenderPass* pass);

#endif
